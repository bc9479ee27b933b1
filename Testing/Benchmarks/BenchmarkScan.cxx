// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "ScanContender.h"
#include "Scenes.h"
#include "Table.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>

namespace
{
constexpr double Beams = 361.0 * 360.0;
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double Megabyte = 1024.0 * 1024.0;

// For more triangles, brute force takes seconds.
constexpr vtkIdType MaximumTrianglesOfBruteForce = 5000;

// The reference takes some microseconds for a beam that meets a small scene, and milliseconds where
// it passes near many triangles.
constexpr int BeamsOfTruth = 129960;
constexpr int BeamsOfTruthOfLargeScene = 10000;
constexpr vtkIdType LargeScene = 50000;

// With fewer triangles, other memory outweighs the scene.
constexpr vtkIdType MinimumTrianglesForMemory = 10000;

// Milliseconds for which one contender is timed before it is the next one's turn.
constexpr double BudgetOfTurn = 60.0;

constexpr int RoundsOfSlow = 3;

// Two threads that are this much faster than one had both cores.
constexpr double SpeedUpWhenQuiet = 1.85;

std::vector<int> GetMethods(const BenchmarkOptions& options)
{
  const std::vector<std::string> names = ScanSubject::GetNames();
  std::vector<int> methods;
  for (const std::string& name : options.Methods.empty() ? names : options.Methods)
  {
    methods.push_back(
      static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin()));
  }
  return methods;
}

std::vector<ScanContender> MakeContenders(
  const BenchmarkScene& scene, const BenchmarkOptions& options)
{
  const vtkIdType triangles = scene.Surface->GetNumberOfPolys();
  const ScanTruth truth(
    scene, triangles > LargeScene ? BeamsOfTruthOfLargeScene : BeamsOfTruth, ScanMaximumRange);
  std::printf("%s: %lld triangles, %d beams compared with the exact reference\n\n",
    scene.Name.c_str(), static_cast<long long>(triangles), truth.GetNumberOfBeams());
  std::vector<ScanContender> contenders;
  contenders.push_back(ScanContender::MakeRaw(scene));
  for (int method : GetMethods(options))
  {
    if (ScanSubject::IsBruteForce(method) &&
      (triangles > MaximumTrianglesOfBruteForce || options.IsQuick))
    {
      ScanContender absent;
      absent.Name = ScanSubject::GetName(method);
      contenders.push_back(std::move(absent));
    }
    else
    {
      contenders.push_back(ScanContender::MakeMethod(scene, method, truth));
    }
  }
  return contenders;
}

void TimeRound(std::vector<ScanContender>& contenders, bool withSlow)
{
  for (int threads : { 1, 2 })
  {
    for (ScanContender& contender : contenders)
    {
      if (contender.IsPresent() && (withSlow || !contender.IsSlow))
      {
        double& best = contender.ByThreads[threads].Scan;
        best = std::min(best, contender.GetScanMilliseconds(BudgetOfTurn, threads));
      }
    }
  }
}

// ScanContenders take turns, so that another program disturbs all of them alike. While another process
// has one of the cores, only waiting helps.
void TimeScans(std::vector<ScanContender>& contenders, bool isQuick)
{
  const int minimumRounds = isQuick ? 3 : 12;
  const int maximumRounds = isQuick ? 10 : 60;
  const auto isDisturbed = [](ScanContender& contender) {
    return contender.IsPresent() && !contender.IsSlow && contender.GetSpeedUp() < SpeedUpWhenQuiet;
  };
  for (int round = 0; round < maximumRounds; ++round)
  {
    TimeRound(contenders, round < (isQuick ? 1 : RoundsOfSlow));
    if (round + 1 >= minimumRounds &&
      std::none_of(contenders.begin(), contenders.end(), isDisturbed))
    {
      return;
    }
  }
}

void TimeBuilds(std::vector<ScanContender>& contenders, const BenchmarkScene& scene, bool isQuick)
{
  const int runs = !isQuick && scene.Surface->GetNumberOfPolys() <= 1000000 ? 5 : 2;
  for (ScanContender& contender : contenders)
  {
    for (auto& [threads, times] : contender.ByThreads)
    {
      for (int run = 0; run < (contender.IsSlow ? 1 : runs); ++run)
      {
        times.Build = std::min(times.Build, contender.GetBuildMilliseconds(scene, threads));
      }
    }
  }
}

std::string FormatBytesPerTriangle(const ScanContender& contender, vtkIdType triangles)
{
  return triangles < MinimumTrianglesForMemory ? "-"
                                               : Table::Format(contender.SceneBytes / triangles, 0);
}

void AddRow(const BenchmarkScene& scene, const ScanContender& contender, int threads, double bound,
  Table& table)
{
  const vtkIdType triangles = scene.Surface->GetNumberOfPolys();
  const auto found = contender.ByThreads.find(threads);
  if (found == contender.ByThreads.end())
  {
    Table::Row row = { scene.Name, contender.Name, std::to_string(triangles),
      std::to_string(threads) };
    row.resize(16, "-");
    table.AddRow(row);
    return;
  }
  const ScanTimes& times = found->second;
  const std::optional<ScanErrors>& errors = contender.Errors;
  table.AddRow({ scene.Name, contender.Name, std::to_string(triangles), std::to_string(threads),
    Table::Format(times.Build, 1), Table::Format(times.Scan, 3),
    Table::Format(Beams / times.Scan / 1000.0, 1), Table::Format(times.Scan / bound, 2),
    FormatBytesPerTriangle(contender, triangles), Table::Format(contender.OutputBytes / Beams, 0),
    Table::Format(contender.PeakBytes / Megabyte, 0), std::to_string(contender.Hits),
    errors ? std::to_string(errors->Misses) : "-", errors ? std::to_string(errors->FalseHits) : "-",
    Table::FormatPower(errors ? errors->Median : None),
    Table::FormatPower(errors ? errors->Worst : None) });
}

std::string FormatCount(std::int64_t count)
{
  std::string digits = std::to_string(count);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
  {
    digits.insert(i, ",");
  }
  return digits;
}

// Both numbers of threads in one row, and what was wrong in another.
void AddSummary(const BenchmarkScene& scene, std::vector<ScanContender>& contenders, Table& summary)
{
  for (ScanContender& contender : contenders)
  {
    if (!contender.IsPresent())
    {
      continue;
    }
    Table::Row row = { scene.Name + ", " + FormatCount(scene.Surface->GetNumberOfPolys()),
      contender.Name };
    for (int threads : { 1, 2 })
    {
      const double scan = contender.ByThreads[threads].Scan;
      row.push_back(Table::Format(scan, 2));
      row.push_back(Table::Format(scan / contenders.front().ByThreads[threads].Scan, 2));
    }
    const std::optional<ScanErrors>& errors = contender.Errors;
    row.push_back(errors ? std::to_string(errors->Misses + errors->FalseHits) : "-");
    row.push_back(Table::FormatPower(errors ? errors->Worst : None));
    summary.AddRow(row);
  }
}

void PrintNotes(std::vector<ScanContender>& contenders)
{
  std::string speedUps;
  for (ScanContender& contender : contenders)
  {
    if (contender.IsPresent())
    {
      speedUps += ' ' + contender.Name + ' ' + Table::Format(contender.GetSpeedUp(), 2) + ';';
    }
  }
  std::printf("2 threads against 1:%s\n\n", speedUps.c_str());
  std::fflush(stdout);
}

void TimeScene(
  const std::string& name, const BenchmarkOptions& options, Table& table, Table& summary)
{
  const BenchmarkScene scene = MakeScene(name);
  std::vector<ScanContender> contenders = MakeContenders(scene, options);
  TimeScans(contenders, options.IsQuick);
  TimeBuilds(contenders, scene, options.IsQuick);
  for (int threads : { 1, 2 })
  {
    const double bound = contenders.front().ByThreads[threads].Scan;
    for (const ScanContender& contender : contenders)
    {
      AddRow(scene, contender, threads, bound, table);
    }
  }
  table.Print();
  PrintNotes(contenders);
  AddSummary(scene, contenders, summary);
}
} // namespace

void RunScanBenchmark(const BenchmarkOptions& options)
{
  Table table({ "scene", "method", "triangles", "threads", "build ms", "scan ms", "Mbeams/s",
    "x raw", "B/triangle", "B/beam", "peak MB", "hits", "misses", "false hits", "median error",
    "worst error" });
  Table summary({ "scene, triangles", "method", "1 thread, ms", "x raw", "2 threads, ms", "x raw",
    "wrong beams", "worst error" });
  for (const std::string& name : options.Scenes)
  {
    TimeScene(name, options, table, summary);
  }
  std::printf("In short:\n\n");
  summary.Print();
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
