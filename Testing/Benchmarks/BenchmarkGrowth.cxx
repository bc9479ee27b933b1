// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "Memory.h"
#include "ScanGrid.h"
#include "Scenes.h"
#include "SeparateProcess.h"
#include "Table.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace
{
struct Limits
{
  /// Powers of ten.
  int MostTriangles;
  int MostBeams;
  int MostBeamsOfMap;
  int TrianglesForThreads;
  /// Milliseconds for which a work is repeated, and the most that one may take.
  double Budget;
  double LongWork;
  unsigned int MostSeconds;
};
constexpr Limits Whole = { 7, 8, 7, 6, 500.0, 16000.0, 120 };
constexpr Limits Quick = { 5, 6, 5, 4, 30.0, 300.0, 20 };

constexpr double MapBound = 0.01; // metres

// Where a default scan takes long, it is one of fewer beams.
constexpr std::array<int, 3> Strides = { 1, 6, 20 };

// Of a scan at the most: what both outputs hold, and what is needed meanwhile.
constexpr double BytesPerBeam = 100.0;

constexpr double Megabyte = 1e6;

/// Milliseconds, and bytes: held for what was made, and the most that was taken at any time.
struct Cost
{
  double Milliseconds;
  double Held;
  double Peak;
};

struct Setting
{
  /// What grows.
  std::string Against;
  const BenchmarkScene& Scene;
  int Alphas = ScanGrid::Alphas;
  int Betas = ScanGrid::Betas;
  int Threads = 1;

  double GetBeams() const { return static_cast<double>(this->Alphas) * this->Betas; }

  /// Fewer beams stand for those of a default scan, not for others.
  bool MayThin() const { return this->Against != "beams"; }
};

/// What is done in a process of its own: gives the beams, milliseconds, and megabytes held and taken.
struct Work
{
  std::string Name;
  std::string Contender;
  std::function<std::vector<double>(const Setting&, const Limits&)> Do;
};

std::vector<double> GetNumbers(const Setting& setting, const Cost& cost)
{
  return { setting.GetBeams(), cost.Milliseconds, cost.Held / Megabyte, cost.Peak / Megabyte };
}

// The first run takes the memory, which costs time of its own; the best of the others counts.
Cost Measure(double budget, const std::function<void()>& prepare, const std::function<void()>& work)
{
  const MemoryMeter meter;
  prepare();
  work();
  Cost cost = { std::numeric_limits<double>::infinity(), meter.GetGrowth(), meter.GetPeak() };
  for (double spent = 0.0; spent < budget;)
  {
    prepare();
    const double ms = GetMilliseconds(work);
    cost.Milliseconds = std::min(cost.Milliseconds, ms);
    spent += ms;
  }
  return cost;
}

Cost MeasureUpdate(vtkAlgorithm* filter, double budget)
{
  return Measure(
    budget, [&] { filter->Modified(); }, [&] { filter->Update(); });
}

/// A filter that has built what its method needs, and has cast one beam.
vtkSmartPointer<vtkLMS3DScanFilter> Build(const Setting& setting, int method)
{
  auto filter = vtkSmartPointer<vtkLMS3DScanFilter>::New();
  const std::array<double, 3>& sensor = setting.Scene.Sensor;
  filter->SetInputData(setting.Scene.Surface);
  filter->SetPosition(sensor[0], sensor[1], sensor[2]);
  filter->SetIntersectionMethod(method);
  filter->SetNumberOfThreads(setting.Threads);
  filter->SetAlphaResolution(1);
  filter->SetBetaResolution(1);
  filter->Update();
  return filter;
}

// What a first filter takes for libraries and threads is not the scene's.
void Load(int method, int threads)
{
  const BenchmarkScene scene = MakeTerrain(2);
  const auto scan = Build({ "", scene, 1, 1, threads }, method);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->SetNumberOfThreads(threads);
  map->Update();
}

std::vector<double> MeasureBuild(const Setting& setting, int method, const Limits& limits)
{
  Load(method, setting.Threads);
  vtkSmartPointer<vtkLMS3DScanFilter> filter;
  const auto discard = [&] { filter = nullptr; };
  const auto build = [&] { filter = Build(setting, method); };
  return GetNumbers(setting, Measure(limits.Budget, discard, build));
}

void Resize(vtkLMS3DScanFilter* filter, Setting& setting, const ScanGrid& grid)
{
  setting.Alphas = grid.GetAlphaResolution();
  setting.Betas = grid.GetBetaResolution();
  filter->SetAlphaResolution(setting.Alphas);
  filter->SetBetaResolution(setting.Betas);
}

// The finest that takes no longer than it may, as far as a scan with the fewest beams tells.
ScanGrid ChooseGrid(vtkLMS3DScanFilter* filter, Setting setting, double longest)
{
  Resize(filter, setting, ScanGrid(Strides.back()));
  const double ms = GetMilliseconds([&] { filter->Update(); }) / setting.GetBeams();
  return ScanGrid(*std::find_if(Strides.begin(), Strides.end() - 1,
    [&](int stride)
    { return ms * static_cast<double>(ScanGrid(stride).GetNumberOfBeams()) <= longest; }));
}

std::vector<double> MeasureScan(Setting setting, int method, const Limits& limits)
{
  Load(method, setting.Threads);
  const auto filter = Build(setting, method);
  filter->SetAlphaResolution(setting.Alphas);
  filter->SetBetaResolution(setting.Betas);
  if (setting.MayThin())
  {
    const ScanGrid grid = ChooseGrid(filter, setting, limits.LongWork);
    Resize(filter, setting, grid);
  }
  return GetNumbers(setting, MeasureUpdate(filter, limits.Budget));
}

std::vector<double> MeasureMap(const Setting& setting, double bound, const Limits& limits)
{
  Load(vtkLMS3DScanFilter::EXACT, setting.Threads);
  const auto scan = Build(setting, vtkLMS3DScanFilter::EXACT);
  scan->SetAlphaResolution(setting.Alphas);
  scan->SetBetaResolution(setting.Betas);
  scan->Update();
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputData(scan->GetOutput());
  map->SetMaximumError(bound);
  map->SetDepthStep(setting.Scene.DepthStep);
  map->SetNumberOfThreads(setting.Threads);
  return GetNumbers(setting, MeasureUpdate(map, limits.Budget));
}

std::vector<Work> GetWorksOfMethods(const std::string& name,
  const std::function<std::vector<double>(const Setting&, int, const Limits&)>& measure)
{
  std::vector<Work> works;
  works.reserve(vtkLMS3DScanFilter::GetNumberOfIntersectionMethods());
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    works.push_back({ name, vtkLMS3DScanFilter::GetIntersectionMethodName(method),
      [measure, method](const Setting& setting, const Limits& limits)
      { return measure(setting, method, limits); } });
  }
  return works;
}

std::vector<Work> GetBuilds()
{
  return GetWorksOfMethods("build", MeasureBuild);
}

std::vector<Work> GetScans()
{
  return GetWorksOfMethods("scan", MeasureScan);
}

std::vector<Work> GetMaps()
{
  std::vector<Work> works;
  for (double bound : { 0.0, MapBound })
  {
    works.push_back({ "map", bound == 0.0 ? "plain grid" : "map within 10 mm",
      [bound](const Setting& setting, const Limits& limits)
      { return MeasureMap(setting, bound, limits); } });
  }
  return works;
}

double GetAvailableMemory()
{
  std::ifstream info("/proc/meminfo");
  for (std::string word; info >> word;)
  {
    if (word == "MemAvailable:")
    {
      double kilobytes = 0.0;
      info >> kilobytes;
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

/// Measures works in one setting after another, and leaves out what would take too long.
class Growth
{
public:
  explicit Growth(const Limits& limits)
    : Limit(limits)
  {
  }

  void Add(const std::vector<Work>& works, const Setting& setting)
  {
    for (const Work& work : works)
    {
      std::fprintf(stderr, "%s, %s, %s: %lld triangles, %.0f beams, %d threads\n",
        setting.Against.c_str(), work.Name.c_str(), work.Contender.c_str(),
        static_cast<long long>(setting.Scene.Surface->GetNumberOfPolys()), setting.GetBeams(),
        setting.Threads);
      this->AddRow(work, setting, this->Try(work, setting));
    }
  }

  const Table& GetTable() const { return this->Rows; }
  void Print() { this->Rows.Print(); }

private:
  SeparateResult Try(const Work& work, const Setting& setting)
  {
    double& last = this->MillisecondsPerBeam[setting.Against + work.Name + work.Contender];
    if (work.Name == "scan" && this->GetPrediction(setting, last) > this->Limit.LongWork)
    {
      return { {}, "takes long" };
    }
    if (BytesPerBeam * setting.GetBeams() > GetAvailableMemory())
    {
      return { {}, "needs more memory" };
    }
    SeparateResult result =
      RunSeparately([&] { return work.Do(setting, this->Limit); }, this->Limit.MostSeconds);
    if (result.Failure.empty())
    {
      last = result.Numbers[1] / result.Numbers[0];
    }
    return result;
  }

  // By the setting before, which had a tenth of the triangles or of the beams.
  double GetPrediction(const Setting& setting, double last) const
  {
    return setting.MayThin()
      ? 10.0 * last * static_cast<double>(ScanGrid(Strides.back()).GetNumberOfBeams())
      : last * setting.GetBeams();
  }

  void AddRow(const Work& work, const Setting& setting, const SeparateResult& result)
  {
    const bool isDone = result.Failure.empty();
    const auto format = [&](std::size_t i, int decimals)
    { return isDone ? Table::Format(result.Numbers[i], decimals) : "-"; };
    this->Rows.AddRow({ work.Name, work.Contender, setting.Against, setting.Scene.Name,
      std::to_string(setting.Scene.Surface->GetNumberOfPolys()),
      isDone ? format(0, 0) : Table::Format(setting.GetBeams(), 0), std::to_string(setting.Threads),
      format(1, 4), format(2, 3), format(3, 3), isDone ? "done" : result.Failure });
  }

  const Limits Limit;
  Table Rows{ { "work", "contender", "against", "scene", "triangles", "beams", "threads", "ms",
    "held MB", "peak MB", "end" } };
  std::map<std::string, double> MillisecondsPerBeam;
};

void GrowTriangles(const Limits& limits, Growth& growth)
{
  for (int power = 2; power <= limits.MostTriangles; ++power)
  {
    const BenchmarkScene scene = MakeTerrain(power);
    const Setting setting = { "triangles", scene };
    growth.Add(GetBuilds(), setting);
    growth.Add(GetScans(), setting);
    growth.Add(GetMaps(), setting);
  }
}

void GrowBeams(const Limits& limits, Growth& growth)
{
  const BenchmarkScene scene = MakeScene("room");
  for (int power = 3; power <= limits.MostBeams; ++power)
  {
    Setting setting = { "beams", scene };
    setting.Alphas = setting.Betas = static_cast<int>(std::round(std::pow(10.0, power / 2.0)));
    growth.Add(GetScans(), setting);
    if (power <= limits.MostBeamsOfMap)
    {
      growth.Add(GetMaps(), setting);
    }
  }
}

void GrowThreads(const Limits& limits, Growth& growth)
{
  const BenchmarkScene room = MakeScene("room");
  const BenchmarkScene terrain = MakeTerrain(limits.TrianglesForThreads);
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  for (int threads = 1; threads <= std::max(2, cores); threads *= 2)
  {
    Setting setting = { "threads", room };
    setting.Threads = threads;
    growth.Add(GetScans(), setting);
    growth.Add(GetMaps(), setting);
    Setting large = { "threads", terrain };
    large.Threads = threads;
    growth.Add(GetBuilds(), large);
  }
}
} // namespace

void RunGrowthBenchmark(const BenchmarkOptions& options)
{
  const Limits& limits = options.IsQuick ? Quick : Whole;
  Growth growth(limits);
  for (const auto grow : { &GrowTriangles, &GrowBeams, &GrowThreads })
  {
    grow(limits, growth);
    growth.Print();
  }
  if (!options.CSVFile.empty())
  {
    growth.GetTable().Save(options.CSVFile);
  }
}
