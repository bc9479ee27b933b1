// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "SeparateProcess.h"
#include "StabilityMethod.h"
#include "StabilityRivals.h"
#include "StabilitySituations.h"
#include "StabilityTruth.h"
#include "Table.h"

#include <cstdio>
#include <limits>

namespace
{
constexpr std::size_t Shots = 200;
constexpr std::size_t ShotsWhenQuick = 20;

// For one method in one situation, which takes seconds.
constexpr unsigned int MaximumSeconds = 120;

std::vector<StabilityMethod> GetMethods()
{
  std::vector<StabilityMethod> methods;
  for (const auto& some :
    { GetFilterMethods(), GetAngleSumMethods(), GetEmbreeMethods(), GetLocatorMethods() })
  {
    methods.insert(methods.end(), some.begin(), some.end());
  }
  return methods;
}

struct Cell
{
  StabilityTally Tally;
  std::string Failure;
};

// A method that fails returns nothing at all.
Cell Measure(const StabilityMethod& method, const StabilityCase& scene, const StabilityTruth& truth)
{
  SeparateResult result = RunSeparately([&] { return method.Cast(scene); }, MaximumSeconds);
  if (!result.Failure.empty())
  {
    result.Numbers.assign(
      scene.Shots.size() * lms3dBeamPacket::Size, std::numeric_limits<double>::infinity());
  }
  return { truth.Judge(result.Numbers), result.Failure };
}

Table::Row MakeRow(
  const StabilityMethod& method, const StabilitySituation& situation, const Cell& cell)
{
  const StabilityTally& tally = cell.Tally;
  return { method.Name, situation.Name, situation.Parameter, std::to_string(tally.Beams),
    std::to_string(tally.Hits), std::to_string(tally.Missed), std::to_string(tally.False),
    std::to_string(tally.Wrong), Table::FormatPower(tally.WorstError),
    cell.Failure.empty() ? "done" : cell.Failure, std::to_string(situation.Seed) };
}

std::string Summarize(const Cell& cell)
{
  if (!cell.Failure.empty())
  {
    return cell.Failure;
  }
  return cell.Tally.GetFailures() == 0 ? "0" : Table::Format(100.0 * cell.Tally.GetShare(), 2);
}
} // namespace

void RunStabilityBenchmark(const BenchmarkOptions& options)
{
  const std::vector<StabilityMethod> methods = GetMethods();
  Table::Row columns = { "situation", "parameter" };
  columns.reserve(columns.size() + methods.size());
  for (const StabilityMethod& method : methods)
  {
    columns.push_back(method.Name);
  }
  Table summary(columns);
  Table table({ "method", "situation", "parameter", "beams", "hits", "missed", "false", "wrong",
    "worst error", "end", "seed" });
  for (const StabilitySituation& situation : GetStabilitySituations())
  {
    std::fprintf(stderr, "%s %s\n", situation.Name.c_str(), situation.Parameter.c_str());
    const StabilityCase scene = situation.MakeCase(options.IsQuick ? ShotsWhenQuick : Shots);
    const StabilityTruth truth(scene);
    Table::Row row = { situation.Name, situation.Parameter };
    row.reserve(columns.size());
    for (const StabilityMethod& method : methods)
    {
      const Cell cell = Measure(method, scene, truth);
      row.push_back(Summarize(cell));
      table.AddRow(MakeRow(method, situation, cell));
    }
    summary.AddRow(row);
  }
  std::printf("Of 100 beams, those missed, false or wrong:\n\n");
  summary.Print();
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
