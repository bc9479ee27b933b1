// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief lms3dBenchmark: reads the command line and runs what it asks for.
 */
#include "Benchmarks.h"
#include "Cores.h"
#include "ScanSubject.h"
#include "Scenes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr int ExitUsage = 2;

struct Benchmark
{
  const char* Name;
  const char* Summary;
  void (*Run)(const BenchmarkOptions& options);
  std::vector<std::string> QuickScenes;
  std::vector<std::string> Scenes = GetSceneNames();
  /// How many cores it needs; 0 stands for all.
  int NumberOfCores = 2;
};

const std::vector<std::string> CastingScenes = { "room", "teapot", "terrain1e5" };

const std::array<Benchmark, 9>& GetBenchmarks()
{
  // The first three start processes, which must not inherit the threads of the others.
  static const std::array<Benchmark, 9> benchmarks = {
    { { "stability",
        "beams that methods miss, invent or measure wrongly where casting is difficult",
        &RunStabilityBenchmark, {}, {} },
      { "casting", "time and error of a beam, by every method and by what else casts beams",
        &RunCastingBenchmark, CastingScenes, CastingScenes },
      { "growth", "time and memory of building, scanning and mapping, against what makes them grow",
        &RunGrowthBenchmark, {}, {}, 0 },
      { "scan", "a scan after a change of pose, every method, beside the raw cost of its beams",
        &RunScanBenchmark, { "room", "castle", "teapot", "terrain1e5" } },
      { "first", "the first scan, building included, beside Embree's own build", &RunFirstBenchmark,
        { "room", "terrain1e5" } },
      { "map", "local maps within error bounds, and what else makes maps: time, triangles, errors",
        &RunMapBenchmark, { "room", "teapot" },
        { "room", "castle", "teapot", "ball", "terrain1e5" } },
      { "decimation",
        "local maps beside decimation: triangles for an equal largest error, mean error",
        &RunDecimationBenchmark, { "teapot" },
        { "ball", "teapot", "castle", "terrain1e3", "terrain1e5", "room" } },
      { "fusion", "one map of the 200 poses of a journey: time, triangles, completeness, changes",
        &RunFusionBenchmark, {}, {} },
      { "read", "a VRML97 file, beside the bare cost of its numbers", &RunReadBenchmark,
        { "room", "terrain1e5" } } }
  };
  return benchmarks;
}

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

void PrintHelp()
{
  std::printf("Usage: ./run bench BENCHMARK [--quick] [--scenes NAME...] [--methods NAME...] "
              "[--csv FILE] [--beams FOLDER]\n\n"
              "Benchmarks; without one, all of them run with --quick:\n");
  for (const Benchmark& benchmark : GetBenchmarks())
  {
    std::printf("  %-10s  %s\n", benchmark.Name, benchmark.Summary);
  }
  std::printf("  %-10s  %s\n", "corba",
    "what fetch() costs beside a bare socket, and the scanner; by ./run bench corba alone");
  std::printf("\nScenes: %s", Join(GetSceneNames()).c_str());
  std::printf("\n\nMethods, of the benchmark scan: %s\n", Join(ScanSubject::GetNames()).c_str());
  std::printf("\n--beams: where the benchmark casting saves scenes, beams and true ranges\n");
  std::printf(
    "\nThe environment variable LMS3D_KERNELS restricts the instruction set of the filter and of "
    "Embree: Baseline, AVX2 or AVX512.\n\n");
}

void CheckNames(
  const char* kind, const std::vector<std::string>& names, const std::vector<std::string>& known)
{
  for (const std::string& name : names)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      throw std::invalid_argument(
        std::string("no ") + kind + " \"" + name + "\"; there are " + Join(known));
    }
  }
}

BenchmarkOptions ReadOptions(int count, char** words)
{
  BenchmarkOptions options;
  std::vector<std::string>* list = nullptr;
  for (int i = 0; i < count; ++i)
  {
    const std::string word = words[i];
    if (word == "--quick")
    {
      options.IsQuick = true;
      list = nullptr;
    }
    else if (word == "--csv" && i + 1 < count)
    {
      options.CSVFile = words[++i];
      list = nullptr;
    }
    else if (word == "--beams" && i + 1 < count)
    {
      options.BeamFolder = words[++i];
      list = nullptr;
    }
    else if (word == "--scenes" || word == "--methods")
    {
      list = word == "--scenes" ? &options.Scenes : &options.Methods;
    }
    else if (list && word[0] != '-')
    {
      list->push_back(word);
    }
    else
    {
      throw std::invalid_argument("cannot understand \"" + word + "\"");
    }
  }
  CheckNames("scene", options.Scenes, GetSceneNames());
  CheckNames("method", options.Methods, ScanSubject::GetNames());
  return options;
}

void Run(const Benchmark& benchmark, BenchmarkOptions options)
{
  if (!options.Methods.empty() && benchmark.Run != &RunScanBenchmark)
  {
    throw std::invalid_argument("--methods is for the benchmark scan");
  }
  if (!options.BeamFolder.empty() && benchmark.Run != &RunCastingBenchmark)
  {
    throw std::invalid_argument("--beams is for the benchmark casting");
  }
  if (!options.Scenes.empty() && benchmark.Scenes.empty())
  {
    throw std::invalid_argument(std::string("--scenes is not for the benchmark ") + benchmark.Name);
  }
  if (options.Scenes.empty())
  {
    options.Scenes = options.IsQuick ? benchmark.QuickScenes : benchmark.Scenes;
  }
  std::printf("%s: %s\n\n", benchmark.Name, benchmark.Summary);
  std::printf("%s\n\n", ReserveCores(benchmark.NumberOfCores).c_str());
  const LoadMeter load;
  benchmark.Run(options);
  const std::string others = DescribeOthers(load.GetShareOfOthers());
  if (!others.empty())
  {
    std::fprintf(stderr, "%s: %s\n", benchmark.Name, others.c_str());
  }
}

void RunAllQuickly()
{
  PrintHelp();
  BenchmarkOptions options;
  options.IsQuick = true;
  for (const Benchmark& benchmark : GetBenchmarks())
  {
    Run(benchmark, options);
  }
}

int RunNamed(int argc, char** argv)
{
  for (const Benchmark& benchmark : GetBenchmarks())
  {
    if (std::strcmp(benchmark.Name, argv[1]) == 0)
    {
      Run(benchmark, ReadOptions(argc - 2, argv + 2));
      return 0;
    }
  }
  PrintHelp();
  const bool isHelp = std::strcmp(argv[1], "help") == 0 || std::strcmp(argv[1], "--help") == 0;
  return isHelp ? 0 : ExitUsage;
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc > 1)
    {
      return RunNamed(argc, argv);
    }
    RunAllQuickly();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "lms3dBenchmark: %s\n", error.what());
    return ExitUsage;
  }
}
