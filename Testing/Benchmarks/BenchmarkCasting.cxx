// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "CastingContender.h"
#include "ScanTruth.h"
#include "Scenes.h"
#include "SeparateProcess.h"
#include "StabilityMethod.h"
#include "Table.h"
#include "ThinnedGrid.h"
#include "Timer.h"

#include <tbb/task_arena.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>

namespace
{
constexpr double NanosecondsPerMillisecond = 1e6;

// The beams of the reference, which takes milliseconds for a beam that passes near many triangles.
constexpr int StrideOfTruthOfLargeScene = 3;
constexpr vtkIdType LargeScene = 50000;

struct Limits
{
  /// Milliseconds for which a caster repeats its scan in a turn, and the most that one may take.
  double Budget;
  double LongScan;
  /// For all that a caster does.
  unsigned int MaximumSeconds;
  /// Turns of each caster, so that what disturbs the machine for a while disturbs all of them.
  int Turns;
};
constexpr Limits Whole = { 500.0, 6000.0, 60, 3 };
constexpr Limits Quick = { 100.0, 500.0, 4, 1 };

/// What a process of its own found out: the stride, milliseconds, and all ranges. The stride is 0
/// where it has yet to be chosen.
std::vector<double> Measure(const CastingContender& contender, const Limits& limits, int stride)
{
  std::vector<double> result;
  tbb::task_arena(1).execute(
    [&]
    {
      const CastingScan scan = contender.Build();
      const ThinnedGrid grid =
        stride > 0 ? ThinnedGrid(stride) : ThinnedGrid::Choose(limits.LongScan, scan.Cast);
      const double best = GetBestMilliseconds(limits.Budget, [&] { scan.Cast(grid); });
      result = { static_cast<double>(grid.GetStride()), best };
      const std::vector<double> ranges = scan.GetRanges(grid);
      result.insert(result.end(), ranges.begin(), ranges.end());
    });
  return result;
}

/// What is true, by the strides of the casters' beams.
using Truths = std::map<int, ScanTruth>;

Truths MakeTruths(const BenchmarkScene& scene)
{
  const bool isLarge = scene.Surface->GetNumberOfPolys() > LargeScene;
  Truths truths;
  for (int stride : ThinnedGrid::Strides)
  {
    const ThinnedGrid grid(isLarge && stride == 1 ? StrideOfTruthOfLargeScene : stride);
    truths.emplace(stride, ScanTruth(scene, grid.GetBeams(), CastingMaximumRange));
  }
  return truths;
}

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
  const ThinnedGrid grid(static_cast<int>(result.Numbers[0]));
  const double beams = static_cast<double>(grid.GetNumberOfBeams());
  const ScanTruth& truth = truths.at(grid.GetStride());
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

template <typename Values>
void Save(const std::string& fileName, const Values& values)
{
  std::ofstream file(fileName, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(values[0])));
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
  Save(start + "directions", ThinnedGrid::MakeDirections(scene));
  Save(start + "ranges", truth.GetRanges());
}

// A turn of a caster that has not failed. One that fails once has no numbers.
void Take(const CastingContender& contender, const Limits& limits, SeparateResult& result)
{
  if (!result.Failure.empty())
  {
    return;
  }
  const bool isFirst = result.Numbers.empty();
  const int stride = isFirst ? 0 : static_cast<int>(result.Numbers[0]);
  SeparateResult other =
    RunSeparately([&] { return Measure(contender, limits, stride); }, limits.MaximumSeconds);
  if (isFirst || !other.Failure.empty() || other.Numbers[1] < result.Numbers[1])
  {
    result = std::move(other);
  }
}

void MeasureScene(const std::string& name, const BenchmarkOptions& options, Table& table)
{
  const BenchmarkScene scene = MakeScene(name);
  const Truths truths = MakeTruths(scene);
  if (!options.BeamFolder.empty())
  {
    SaveBeams(options.BeamFolder, scene, truths.at(1));
  }
  const Limits& limits = options.IsQuick ? Quick : Whole;
  const std::vector<CastingContender> contenders = MakeCastingContenders(scene);
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
