// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "GrowthWork.h"
#include "Memory.h"
#include "Scenes.h"
#include "SeparateProcess.h"
#include "Table.h"
#include "ThinnedGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace
{
struct Plan
{
  /// Powers of ten.
  int MaximumTriangles;
  int MaximumBeams;
  int MaximumBeamsOfMap;
  int TrianglesForThreads;
  /// Turns of each number of threads, so that what disturbs the machine for a while disturbs all.
  int Turns;
  unsigned int MaximumSeconds;
  GrowthLimits Limits;
};
constexpr Plan Whole = { 7, 8, 7, 6, 3, 120, { 500.0, 6000.0, 25000.0 } };
constexpr Plan Quick = { 5, 6, 5, 4, 1, 20, { 30.0, 300.0, 1000.0 } };

// The maximum for a scan: the memory of both outputs, and the memory needed meanwhile.
constexpr double BytesPerBeam = 100.0;

/// Measures works in one setting after another, and leaves out what would take too long.
class Growth
{
public:
  explicit Growth(const Plan& plan)
    : Schedule(plan)
  {
  }

  void Add(const std::vector<GrowthWork>& works, const GrowthSetting& setting)
  {
    for (const GrowthWork& work : works)
    {
      this->AddRow(work, setting, this->Try(work, setting));
    }
  }

  /// Each work in all settings, turn after turn; the best time of each counts.
  void AddInTurns(const std::vector<GrowthWork>& works, const std::vector<GrowthSetting>& settings)
  {
    for (const GrowthWork& work : works)
    {
      std::vector<SeparateResult> best(settings.size());
      for (int turn = 0; turn < this->Schedule.Turns; ++turn)
      {
        for (std::size_t i = 0; i < settings.size(); ++i)
        {
          TakeBetter(this->Try(work, settings[i]), best[i]);
        }
      }
      for (std::size_t i = 0; i < settings.size(); ++i)
      {
        this->AddRow(work, settings[i], best[i]);
      }
    }
  }

  const Table& GetTable() const { return this->Rows; }
  void Print() { this->Rows.Print(); }

private:
  SeparateResult Try(const GrowthWork& work, const GrowthSetting& setting)
  {
    std::fprintf(stderr, "%s, %s, %s: %lld triangles, %.0f beams, %d threads\n",
      setting.Against.c_str(), work.Name.c_str(), work.Contender.c_str(),
      static_cast<long long>(setting.Scene.Surface->GetNumberOfPolys()), setting.GetBeams(),
      setting.Threads);
    double& last = this->MillisecondsPerBeam[setting.Against + work.Name + work.Contender];
    if (work.Name == "scan" && GetPrediction(setting, last) > this->Schedule.Limits.LongWork)
    {
      return { {}, "takes long" };
    }
    if (BytesPerBeam * setting.GetBeams() > GetAvailableMemory())
    {
      return { {}, "needs more memory" };
    }
    SeparateResult result = RunSeparately(
      [&] { return work.Do(setting, this->Schedule.Limits); }, this->Schedule.MaximumSeconds);
    if (result.Failure.empty())
    {
      last = GetMillisecondsPerBeam(result);
    }
    return result;
  }

  static double GetMillisecondsPerBeam(const SeparateResult& result)
  {
    return result.Numbers[1] / result.Numbers[0];
  }

  static void TakeBetter(SeparateResult other, SeparateResult& best)
  {
    if (best.Numbers.empty() ||
      (other.Failure.empty() && GetMillisecondsPerBeam(other) < GetMillisecondsPerBeam(best)))
    {
      best = std::move(other);
    }
  }

  // By the setting before, which had a tenth of the triangles or of the beams.
  static double GetPrediction(const GrowthSetting& setting, double last)
  {
    const std::size_t minimumBeams = ThinnedGrid(ThinnedGrid::Strides.back()).GetNumberOfBeams();
    const double growth = setting.Against == "triangles" ? 10.0 : 1.0;
    return growth * last *
      (setting.MayThin() ? static_cast<double>(minimumBeams) : setting.GetBeams());
  }

  void AddRow(const GrowthWork& work, const GrowthSetting& setting, const SeparateResult& result)
  {
    const bool isDone = result.Failure.empty();
    const auto format = [&](std::size_t i, int decimals)
    { return isDone ? Table::Format(result.Numbers[i], decimals) : "-"; };
    this->Rows.AddRow({ work.Name, work.Contender, setting.Against, setting.Scene.Name,
      std::to_string(setting.Scene.Surface->GetNumberOfPolys()),
      isDone ? format(0, 0) : Table::Format(setting.GetBeams(), 0), std::to_string(setting.Threads),
      format(1, 4), format(2, 3), format(3, 3), isDone ? "done" : result.Failure });
  }

  const Plan& Schedule;
  Table Rows{ { "work", "contender", "against", "scene", "triangles", "beams", "threads", "ms",
    "held MB", "peak MB", "end" } };
  std::map<std::string, double> MillisecondsPerBeam;
};

void GrowTriangles(const Plan& plan, Growth& growth)
{
  for (int power = 2; power <= plan.MaximumTriangles; ++power)
  {
    const BenchmarkScene scene = MakeTerrain(power);
    const GrowthSetting setting = { "triangles", scene };
    growth.Add(GetGrowthBuilds(), setting);
    growth.Add(GetGrowthScans(), setting);
    growth.Add(GetGrowthMaps(), setting);
  }
}

void GrowBeams(const Plan& plan, Growth& growth)
{
  const BenchmarkScene scene = MakeScene("room");
  for (int power = 3; power <= plan.MaximumBeams; ++power)
  {
    GrowthSetting setting = { "beams", scene };
    setting.Alphas = setting.Betas = static_cast<int>(std::round(std::pow(10.0, power / 2.0)));
    growth.Add(GetGrowthScans(), setting);
    if (power <= plan.MaximumBeamsOfMap)
    {
      growth.Add(GetGrowthMaps(), setting);
    }
  }
}

/// One for each number of threads, up to all cores, and two at least.
std::vector<GrowthSetting> MakeSettingsOfThreads(const BenchmarkScene& scene)
{
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  std::vector<GrowthSetting> settings;
  for (int threads = 1; threads <= std::max(2, cores); threads *= 2)
  {
    settings.push_back({ "threads", scene });
    settings.back().Threads = threads;
  }
  return settings;
}

void GrowThreads(const Plan& plan, Growth& growth)
{
  const BenchmarkScene room = MakeScene("room");
  growth.AddInTurns(GetGrowthScans(), MakeSettingsOfThreads(room));
  growth.AddInTurns(GetGrowthMaps(), MakeSettingsOfThreads(room));
  const BenchmarkScene terrain = MakeTerrain(plan.TrianglesForThreads);
  growth.AddInTurns(GetGrowthBuilds(), MakeSettingsOfThreads(terrain));
}
} // namespace

void RunGrowthBenchmark(const BenchmarkOptions& options)
{
  const Plan& plan = options.IsQuick ? Quick : Whole;
  Growth growth(plan);
  for (const auto grow : { &GrowTriangles, &GrowBeams, &GrowThreads })
  {
    grow(plan, growth);
    growth.Print();
  }
  if (!options.CSVFile.empty())
  {
    growth.GetTable().Save(options.CSVFile);
  }
}
