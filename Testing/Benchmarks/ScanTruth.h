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

struct BenchmarkScene;

struct ScanErrors
{
  int Misses = 0;
  int FalseHits = 0;
  /// Relative errors of the ranges where both hit; not a number where none did. Of a thousand one
  /// is above the second.
  double Median;
  double Percentile999;
  double Worst;
};

class ScanTruth
{
public:
  /// Casts some beams with the exact reference, numbered as in a default scan.
  ScanTruth(const BenchmarkScene& scene, std::vector<std::size_t> beams, double maximumRange);

  /// The same for about a given number of beams, spread evenly.
  ScanTruth(const BenchmarkScene& scene, int count, double maximumRange);

  int GetNumberOfBeams() const { return static_cast<int>(this->Ranges.size()); }
  int GetNumberOfHits() const;

  /// Compares with the ranges of all beams of a default scan, infinite or not a number where there
  /// is no return.
  ScanErrors GetErrors(const double* ranges) const;

  /// The range of each beam of a default scan, infinite where there is no return, and not a number
  /// where the reference was not cast.
  std::vector<double> GetRanges() const;

private:
  std::vector<std::size_t> Beams;
  std::vector<double> Ranges;
  double MaximumRange;
};

#endif
