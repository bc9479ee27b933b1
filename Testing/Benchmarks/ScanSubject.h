// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan filter with one method of intersection, on one scene.
 */
#ifndef ScanSubject_h
#define ScanSubject_h

#include "ScanTruth.h"

#include <vtkNew.h>

#include <string>
#include <vector>

class vtkLMS3DScanFilter;
struct BenchmarkScene;

class ScanSubject
{
public:
  /// Builds, scans, and measures the memory of both; `method` is one of vtkLMS3DScanFilter's.
  ScanSubject(const BenchmarkScene& scene, int method);
  ~ScanSubject();

  /// A whole update after a change of pose alone.
  double GetScanMilliseconds(double budget, int threads);

  /// The first update of a filter that casts one beam alone.
  static double GetBuildMilliseconds(const BenchmarkScene& scene, int method, int threads);

  /// The first update of a filter, building included.
  static double GetFirstMilliseconds(const BenchmarkScene& scene, int method, int threads);

  int GetHits() const { return this->Hits; }
  ScanErrors GetErrors(const ScanTruth& truth);

  /// Bytes held for the scene, and for the outputs; and the most that was taken at any time.
  double GetSceneBytes() const { return this->SceneBytes; }
  double GetOutputBytes() const { return this->OutputBytes; }
  double GetPeakBytes() const { return this->PeakBytes; }

  /// A beam takes a long time, the longer the more triangles there are.
  static bool IsBruteForce(int method);
  static std::string GetName(int method);
  /// Returns the names of all methods, by number.
  static std::vector<std::string> GetNames();

private:
  vtkNew<vtkLMS3DScanFilter> Filter;
  int Hits = 0;
  double SceneBytes = 0.0;
  double OutputBytes = 0.0;
  double PeakBytes = 0.0;
};

#endif
