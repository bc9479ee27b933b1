// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "ScanContender.h"
#include "ScanGrid.h"
#include "Scenes.h"
#include "SeparateProcess.h"
#include "StabilityMethod.h"
#include "StabilityRivals.h"
#include "Table.h"
#include "Timer.h"

#include "vtkLMS3DScanFilter.h"

#include <tbb/task_arena.h>

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>

namespace
{
constexpr double NanosecondsPerMillisecond = 1e6;

// Of the reference, which takes milliseconds for a beam that passes near many triangles.
constexpr int StrideOfTruthOfLargeScene = 3;
constexpr vtkIdType LargeScene = 50000;

// Of casters that take long.
constexpr int StrideOfSlow = 6;

struct Limits
{
  /// Milliseconds for which a caster repeats its scan, and the most that one may take.
  double Budget;
  double LongScan;
  /// For all that a caster does.
  unsigned int MostSeconds;
  /// Turns of each caster, so that what disturbs the machine for a while disturbs all of them.
  int Turns;
};
constexpr Limits Whole = { 500.0, 20000.0, 60, 3 };
constexpr Limits Quick = { 100.0, 500.0, 4, 1 };

/// A scene that is ready to be scanned.
struct Scan
{
  std::function<void(const ScanGrid&)> Cast;
  /// The ranges of the last cast by the beams' numbers in the whole grid.
  std::function<std::vector<double>(const ScanGrid&)> GetRanges;
};

struct Contender
{
  std::string Name;
  std::function<Scan()> Build;
};

// The whole update, with all arrays of both outputs.
Contender MakeMethod(const BenchmarkScene& scene, int method)
{
  const auto build = [&scene, method]() -> Scan
  {
    const auto filter = vtkSmartPointer<vtkLMS3DScanFilter>::New();
    filter->SetInputData(scene.Surface);
    filter->SetPosition(scene.Sensor[0], scene.Sensor[1], scene.Sensor[2]);
    filter->SetIntersectionMethod(method);
    filter->SetNumberOfThreads(1);
    filter->SetAlphaResolution(1);
    filter->SetBetaResolution(1);
    filter->Update();
    const auto cast = [filter](const ScanGrid& grid)
    {
      filter->SetAlphaResolution(grid.GetAlphaResolution());
      filter->SetBetaResolution(grid.GetBetaResolution());
      filter->Modified();
      filter->Update();
    };
    const auto getRanges = [filter](const ScanGrid& grid)
    {
      vtkDataArray* ranges = filter->GetRangeImage()->GetPointData()->GetScalars();
      return grid.SpreadGrid(vtkDoubleArray::SafeDownCast(ranges)->GetPointer(0));
    };
    return { cast, getRanges };
  };
  return { vtkLMS3DScanFilter::GetIntersectionMethodName(method), build };
}

// Ready-made directions in, ranges out. Both grids have shots of their own, by stride.
Contender MakeRival(const BenchmarkScene& scene, const StabilityMethod& method)
{
  const auto build = [&scene, method]() -> Scan
  {
    const StabilityCaster caster = method.Build(MakeMesh(scene.Surface));
    const auto shots = std::make_shared<std::map<int, std::vector<StabilityShot>>>();
    for (int stride : { 1, StrideOfSlow })
    {
      (*shots)[stride] = ScanGrid(stride).MakeShots(scene);
    }
    const auto ranges = std::make_shared<std::vector<double>>();
    return { [caster, shots, ranges](const ScanGrid& grid)
      { *ranges = caster(shots->at(grid.GetStride())); },
      [ranges](const ScanGrid& grid) { return grid.SpreadShots(*ranges); } };
  };
  return { method.Name, build };
}

std::vector<Contender> MakeContenders(const BenchmarkScene& scene)
{
  const int methods = vtkLMS3DScanFilter::GetNumberOfIntersectionMethods();
  std::vector<Contender> contenders;
  contenders.reserve(methods);
  for (int method = 0; method < methods; ++method)
  {
    contenders.push_back(MakeMethod(scene, method));
  }
  for (const auto& rivals : { GetEmbreeMethods(), GetLocatorMethods() })
  {
    for (const StabilityMethod& rival : rivals)
    {
      contenders.push_back(MakeRival(scene, rival));
    }
  }
  return contenders;
}

/// What a process of its own found out: the stride, milliseconds, and all ranges.
std::vector<double> Measure(const Contender& contender, const Limits& limits)
{
  std::vector<double> result;
  tbb::task_arena(1).execute(
    [&]
    {
      const Scan scan = contender.Build();
      const ScanGrid some(StrideOfSlow);
      const ScanGrid all(1);
      const double first = GetMilliseconds([&] { scan.Cast(some); });
      const double factor =
        static_cast<double>(all.GetNumberOfBeams()) / static_cast<double>(some.GetNumberOfBeams());
      const ScanGrid& grid = factor * first > limits.LongScan ? some : all;
      const double best = GetBestMilliseconds(limits.Budget, [&] { scan.Cast(grid); });
      result = { static_cast<double>(grid.GetStride()), best };
      const std::vector<double> ranges = scan.GetRanges(grid);
      result.insert(result.end(), ranges.begin(), ranges.end());
    });
  return result;
}

/// What is true, for casters of the whole grid and of some beams.
struct Truths
{
  explicit Truths(const BenchmarkScene& scene)
    : All(scene,
        ScanGrid(scene.Surface->GetNumberOfPolys() > LargeScene ? StrideOfTruthOfLargeScene : 1)
          .GetBeams(),
        ScanMaximumRange)
    , Some(scene, ScanGrid(StrideOfSlow).GetBeams(), ScanMaximumRange)
  {
  }

  ScanTruth All;
  ScanTruth Some;
};

Table::Row MakeRow(const BenchmarkScene& scene, const std::string& name,
  const SeparateResult& result, const Truths& truths)
{
  Table::Row row = { scene.Name, name, std::to_string(scene.Surface->GetNumberOfPolys()), "1" };
  if (!result.Failure.empty())
  {
    row.resize(13, "-");
    row.push_back(result.Failure);
    return row;
  }
  const ScanGrid grid(static_cast<int>(result.Numbers[0]));
  const double beams = static_cast<double>(grid.GetNumberOfBeams());
  const ScanTruth& truth = grid.GetStride() == 1 ? truths.All : truths.Some;
  const ScanErrors errors = truth.GetErrors(result.Numbers.data() + 2);
  const Table::Row cells = { Table::Format(beams, 0),
    Table::Format(NanosecondsPerMillisecond * result.Numbers[1] / beams, 1),
    std::to_string(truth.GetNumberOfBeams()), std::to_string(truth.GetNumberOfHits()),
    std::to_string(errors.Misses), std::to_string(errors.FalseHits),
    Table::FormatPower(errors.Median), Table::FormatPower(errors.Percentile999),
    Table::FormatPower(errors.Worst), "done" };
  row.insert(row.end(), cells.begin(), cells.end());
  return row;
}

template <typename T>
void Save(const std::string& fileName, const std::vector<T>& values)
{
  std::ofstream file(fileName, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(T)));
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

// For casters that are not C++: the bare numbers of each array, in a file of its own.
void SaveBeams(const std::string& folder, const BenchmarkScene& scene, const ScanTruth& truth)
{
  const std::string start = folder + "/" + scene.Name + ".";
  const lms3dTriangleMesh mesh = MakeMesh(scene.Surface);
  Save(start + "points", mesh.Points);
  Save(start + "triangles", mesh.Triangles);
  Save(start + "sensor", std::vector<Vector>{ scene.Sensor });
  Save(start + "directions", ScanGrid::MakeDirections(scene));
  Save(start + "ranges", truth.GetRanges());
}

// A turn of a caster that has not failed, and does not take long.
void Take(const Contender& contender, const Limits& limits, SeparateResult& result)
{
  const bool isFirst = result.Numbers.empty();
  if (!result.Failure.empty() || (!isFirst && result.Numbers[1] > limits.Budget))
  {
    return;
  }
  SeparateResult other =
    RunSeparately([&] { return Measure(contender, limits); }, limits.MostSeconds);
  const bool isSame = other.Failure.empty() && !isFirst && other.Numbers[0] == result.Numbers[0];
  if (isFirst || (isSame && other.Numbers[1] < result.Numbers[1]))
  {
    result = std::move(other);
  }
}

void MeasureScene(const std::string& name, const BenchmarkOptions& options, Table& table)
{
  const BenchmarkScene scene = MakeScene(name);
  const Truths truths(scene);
  if (!options.BeamFolder.empty())
  {
    SaveBeams(options.BeamFolder, scene, truths.All);
  }
  const Limits& limits = options.IsQuick ? Quick : Whole;
  const std::vector<Contender> contenders = MakeContenders(scene);
  std::vector<SeparateResult> results(contenders.size());
  for (int turn = 0; turn < limits.Turns; ++turn)
  {
    std::fprintf(stderr, "%s, turn %d of %d\n", name.c_str(), turn + 1, limits.Turns);
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      Take(contenders[i], limits, results[i]);
    }
  }
  for (std::size_t i = 0; i < contenders.size(); ++i)
  {
    table.AddRow(MakeRow(scene, contenders[i].Name, results[i], truths));
  }
  table.Print();
}
} // namespace

void RunCastingBenchmark(const BenchmarkOptions& options)
{
  Table table(
    { "scene", "caster", "triangles", "threads", "beams timed", "ns/beam", "beams compared", "hits",
      "misses", "false hits", "median error", "99.9% error", "worst error", "end" });
  for (const std::string& name : options.Scenes)
  {
    MeasureScene(name, options, table);
  }
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
