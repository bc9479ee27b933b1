// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the beams of a case truly hit, and what a ray caster made of them.
 */
#ifndef StabilityTruth_h
#define StabilityTruth_h

#include "ExactReference.h"
#include "StabilityCase.h"

#include <cstddef>
#include <vector>

struct StabilityTally
{
  std::size_t Beams = 0;
  /// Those that truly hit.
  std::size_t Hits = 0;
  /// Hits that were not returned.
  std::size_t Missed = 0;
  /// Returns of beams that hit nothing.
  std::size_t False = 0;
  /// Returns whose range is off by more than a millionth.
  std::size_t Wrong = 0;
  /// The largest error of the range where both hit, relative, and in units of its last place.
  double WorstError = 0.0;
  double WorstUnits = 0.0;

  std::size_t GetFailures() const { return this->Missed + this->False + this->Wrong; }
  double GetShare() const
  {
    return static_cast<double>(this->GetFailures()) / static_cast<double>(this->Beams);
  }
};

class StabilityTruth
{
public:
  /// Casts with the exact reference, in this thread alone. Triangles that are not finite are
  /// skipped.
  explicit StabilityTruth(const StabilityCase& scene);

  /// Judges the ranges of all beams, in the order of the shots.
  StabilityTally Judge(const std::vector<double>& ranges) const;

private:
  std::vector<ExactReference::Hit> Hits;
  /// The hits belong to the scene scaled by 2 to this power.
  int Exponent = 0;
};

#endif
