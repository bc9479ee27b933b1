// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Marks where the beams of a scan passed through a plane.
 */
#ifndef lms3dPassedBeams_h
#define lms3dPassedBeams_h

#include "Fusion/lms3dFusedPlane.h"
#include "Fusion/lms3dPassages.h"
#include "Fusion/lms3dSeenRanges.h"

#include <cstddef>

/// Keeps memory from plane to plane.
class lms3dPassedBeams
{
public:
  /// A beam passed if its return is farther than the plane by more than `maximumError`, metres. If
  /// `forgets`, the returns of other scans between beams that all passed are taken out.
  lms3dPassedBeams(double maximumError, bool forgets)
    : Forgets(forgets)
    , Passages(maximumError)
  {
  }

  /// Sets Passed of the blocks of a plane from `firstBlock` on, and Open between the beams that
  /// passed them.
  void Mark(const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, int firstBlock);

private:
  void MarkBeam(const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, int firstBlock,
    std::size_t number) const;
  void MarkAround(const lms3dBeamTable& table, lms3dFusedPlane& plane, std::size_t number) const;
  template <typename Points>
  void Open(lms3dFusedPlane& plane, const Points& points) const;

  const bool Forgets;
  lms3dPassages Passages;
};

#endif
