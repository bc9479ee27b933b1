// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One of those that the benchmark compares: Embree's raw packets, or a method of the filter.
 */
#ifndef ScanContender_h
#define ScanContender_h

#include "RawEmbreeScan.h"
#include "ScanSubject.h"
#include "ScanTruth.h"

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

/// The filter's default, metres.
constexpr double ScanMaximumRange = 80.0;

/// Milliseconds, the best so far.
struct ScanTimes
{
  double Build = std::numeric_limits<double>::infinity();
  double Scan = std::numeric_limits<double>::infinity();
};

struct ScanContender
{
  static ScanContender MakeRaw(const BenchmarkScene& scene);
  static ScanContender MakeMethod(const BenchmarkScene& scene, int method, const ScanTruth& truth);

  /// False for a method that is not run on this scene.
  bool IsPresent() const { return this->Raw || this->Subject; }

  double GetScanMilliseconds(double budget, int threads);
  double GetBuildMilliseconds(const BenchmarkScene& scene, int threads) const;

  /// Two threads against one.
  double GetSpeedUp() { return this->ByThreads[1].Scan / this->ByThreads[2].Scan; }

  std::string Name;
  /// A few runs are enough, since a scan takes long.
  bool IsSlow = false;
  int Hits = 0;
  double SceneBytes = std::numeric_limits<double>::quiet_NaN();
  double OutputBytes = std::numeric_limits<double>::quiet_NaN();
  double PeakBytes = std::numeric_limits<double>::quiet_NaN();
  std::optional<ScanErrors> Errors;
  std::map<int, ScanTimes> ByThreads;

private:
  std::unique_ptr<RawEmbreeScan> Raw;
  std::unique_ptr<ScanSubject> Subject;
  int Method = 0;
};

#endif
