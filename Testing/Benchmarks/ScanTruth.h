// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What some of the beams of a scan truly hit, and how far a scan is from it.
 */
#ifndef ScanTruth_h
#define ScanTruth_h

#include <cstddef>
#include <vector>

class vtkImageData;
struct BenchmarkScene;

struct ScanErrors
{
  int Misses = 0;
  int FalseHits = 0;
  /// Relative errors of the ranges where both hit; not a number where none did.
  double Median;
  double Worst;
};

class ScanTruth
{
public:
  /// Asks the exact reference for about so many beams, spread evenly over the default grid.
  ScanTruth(const BenchmarkScene& scene, int beams, double maximumRange);

  int GetNumberOfBeams() const { return static_cast<int>(this->Ranges.size()); }

  ScanErrors GetErrors(vtkImageData* rangeImage) const;

private:
  std::size_t Step;
  /// Infinite where there is no return.
  std::vector<double> Ranges;
};

#endif
