// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "Casting/lms3dEmbreeConfiguration.h"
#include "Cores.h"
#include "ScanContender.h"
#include "ScanTables.h"
#include "Scenes.h"

#include <algorithm>
#include <cstdio>

namespace
{
// For more triangles, brute force takes seconds.
constexpr vtkIdType MaximumTrianglesOfBruteForce = 5000;

// The reference takes some microseconds for a beam that meets a small scene, and milliseconds where
// it passes near many triangles.
constexpr int BeamsOfTruth = 129960;
constexpr int BeamsOfTruthOfLargeScene = 10000;
constexpr vtkIdType LargeScene = 50000;

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

// ScanContenders take turns, so that another program disturbs all of them alike. While another
// process has one of the cores, only waiting helps.
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

void TimeScene(const std::string& name, const BenchmarkOptions& options, ScanTables& tables)
{
  const BenchmarkScene scene = MakeScene(name);
  std::vector<ScanContender> contenders = MakeContenders(scene, options);
  const LoadMeter load;
  TimeScans(contenders, options.IsQuick);
  const double shareOfOthers = load.GetShareOfOthers();
  TimeBuilds(contenders, scene, options.IsQuick);
  tables.AddScene(scene, contenders, shareOfOthers);
}
} // namespace

void RunScanBenchmark(const BenchmarkOptions& options)
{
  const char* embree = lms3dGetEmbreeConfiguration();
  std::printf("Instruction set of the filter: %s; of Embree: %s\n\n", lms3dGetPacketKernels().Name,
    embree ? embree : "the widest");
  ScanTables tables;
  for (const std::string& name : options.Scenes)
  {
    TimeScene(name, options, tables);
  }
  tables.PrintSummary();
  if (!options.CSVFile.empty())
  {
    tables.Save(options.CSVFile);
  }
}
