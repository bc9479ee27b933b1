// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A plane of some returns of several scans.
 */
#ifndef lms3dReturnPlane_h
#define lms3dReturnPlane_h

#include "Fusion/Scans/lms3dLocalMap.h"

#include <optional>
#include <vector>

/// World coordinates, metres.
struct lms3dReturnPlane
{
  /// The cosine of the largest angle between a beam and the normal of a plane that explains it.
  static constexpr double SmallestCosine = 0.1;

  /// The distance in front of the plane.
  double GetHeight(const lms3dVector& point) const
  {
    return lms3dDot(this->Normal, lms3dSubtract(point, this->Centre));
  }

  /// Whether a return lies within `bound` of the plane, and the plane is not nearer than the return
  /// by more, along the beam.
  bool Explains(const lms3dMappedReturn& mapped, double bound) const
  {
    const double height = this->GetHeight(mapped.Point);
    const double cosine = -lms3dDot(this->Normal, mapped.Direction);
    return cosine >= SmallestCosine &&
      (height >= 0.0 ? height <= bound : -height <= bound * cosine);
  }

  lms3dVector Centre;
  /// Towards the sensors, with length 1.
  lms3dVector Normal;
};

/// Returns the plane that fits some returns best. If the root mean square of their distances from a
/// line is at most `width`, it is the plane through the line that is across the beams. Returns none
/// if the beams graze it. `numbers` must not be empty.
std::optional<lms3dReturnPlane> lms3dFitReturns(
  const std::vector<lms3dMappedReturn>& returns, const std::vector<int>& numbers, double width);

#endif
