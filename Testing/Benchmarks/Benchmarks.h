// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The benchmarks, each a table.
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include <string>
#include <vector>

struct BenchmarkOptions
{
  std::vector<std::string> Scenes;
  /// Names of vtkLMS3DScanFilter's methods; all where empty.
  std::vector<std::string> Methods;
  /// Where to save the table, or empty.
  std::string CSVFile;
  /// Where to save scenes, beams and what they truly hit, or empty.
  std::string BeamFolder;
  bool IsQuick = false;
};

/// What share of the beams each method misses, invents or measures wrongly, in each situation of
/// the stability suite.
void RunStabilityBenchmark(const BenchmarkOptions& options);

/// The time of a beam and the error of its range, by every method and by what else casts beams.
void RunCastingBenchmark(const BenchmarkOptions& options);

/// Time and memory of building, scanning and mapping against triangles, beams and threads.
void RunGrowthBenchmark(const BenchmarkOptions& options);

/// A scan after a change of pose alone, by every method, beside the raw cost of its beams.
void RunScanBenchmark(const BenchmarkOptions& options);

/// The first scan, building included, beside Embree's own build.
void RunFirstBenchmark(const BenchmarkOptions& options);

/// A journey of 200 poses through the building with 1 and 2 threads: time of scan, map and fusion
/// for each pose, triangles, completeness, and bytes of what changed.
void RunFusionBenchmark(const BenchmarkOptions& options);

/// Reading a scene as a VRML97 file, beside the bare cost of its numbers.
void RunReadBenchmark(const BenchmarkOptions& options);

/// Local maps within several error bounds, without and with noise, beside what else makes maps:
/// time, triangles and errors. If the room is among the scenes, there is a second table, which
/// CompareDamagedScans makes; its file has "-damage" in its name.
void RunMapBenchmark(const BenchmarkOptions& options);

/// Local maps beside vtkQuadricDecimation, without and with noise: its triangles for the same
/// largest distance of a return, and its mean error with as many triangles.
void RunDecimationBenchmark(const BenchmarkOptions& options);

/// Local maps of scans of the room with beams lost, stray returns, noise and steps, with gaps left
/// open and closed. Each time is the best of the runs within a budget (ms). Without a file name,
/// the table is only printed.
void CompareDamagedScans(const std::string& csvFile, double budget);

#endif
