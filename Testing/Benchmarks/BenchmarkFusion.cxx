// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "FusionJourney.h"
#include "Table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace
{
/// Poses after which a row of the table follows.
const std::vector<int> Whole = { 1, 2, 5, 10, 20, 35, 50, 75, 100, 125, 150, 175, 200 };
const std::vector<int> Quick = { 1, 2, 3, 5, 7, 10, 15, 20 };

constexpr std::array<int, 2> NumbersOfThreads = { 1, 2 };
constexpr double Percent = 100.0;
constexpr double BytesPerKilobyte = 1000.0;

void AddRow(
  int poses, int threads, const FusionTimes& times, const FusionSizes& sizes, Table& table)
{
  table.AddRow({ std::to_string(poses), std::to_string(threads), Table::Format(times.Scan, 2),
    Table::Format(times.Map, 2), Table::Format(times.Fusion, 2),
    Table::Format(times.SlowestFusion, 2), std::to_string(sizes.Triangles),
    std::to_string(sizes.TrianglesOfAllMaps), std::to_string(sizes.TrianglesOfScene),
    Table::Format(
      static_cast<double>(sizes.Triangles) / static_cast<double>(sizes.TrianglesOfScene), 1),
    Table::Format(Percent * sizes.Completeness, 2),
    Table::Format(Percent * sizes.CompletenessOfAllMaps, 2),
    Table::Format(sizes.ChangedBytes / BytesPerKilobyte, 1),
    Table::Format(sizes.Bytes / BytesPerKilobyte, 1) });
}
} // namespace

void RunFusionBenchmark(const BenchmarkOptions& options)
{
  const std::vector<int>& stops = options.IsQuick ? Quick : Whole;
  Table table({ "poses", "threads", "scan ms", "map ms", "fusion ms", "slowest fusion ms",
    "triangles", "triangles of all maps", "triangles of the visible scene", "x visible scene",
    "complete %", "all maps complete %", "changed kB", "whole kB" });
  for (const int threads : NumbersOfThreads)
  {
    FusionJourney journey(threads);
    for (const int stop : stops)
    {
      const FusionTimes times = journey.DriveTo(stop);
      AddRow(stop, threads, times, journey.Measure(), table);
    }
  }
  table.Print();
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
