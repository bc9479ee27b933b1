// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Marks where the beams of a scan passed through a plane.
 */
#ifndef lms3dPassedBeams_h
#define lms3dPassedBeams_h

#include "Fusion/lms3dFusedPlane.h"
#include "Fusion/lms3dSeenRanges.h"

#include <vector>

/// Keeps references, and memory from block to block.
class lms3dPassedBeams
{
public:
  /// A beam passed if its return is farther than the plane by more than `maximumError`, metres. If `forgets`, the
  /// returns of other scans between beams that all passed are taken out.
  lms3dPassedBeams(const lms3dSeenRanges& ranges, double maximumError, bool forgets)
    : Ranges(ranges)
    , MaximumError(maximumError)
    , Forgets(forgets)
  {
  }

  /// Sets Passed of the blocks of a plane from `firstBlock` on, and Open between the beams that
  /// passed them.
  void Mark(lms3dFusedPlane& plane, int firstBlock);

private:
  /// Where a beam passed, cells.
  struct Passage
  {
    bool IsPassed = false;
    lms3dPoint2 Place = {};
  };

  void FindBins(const lms3dFusedPlane& plane, int firstBlock);
  bool IsSurelyShort(int beamId, double range) const;
  Passage Find(const lms3dFusedPlane& plane, int beamId) const;
  void MarkBeam(lms3dFusedPlane& plane, int firstBlock, int beamId);
  void MarkAround(lms3dFusedPlane& plane, int beamId, const lms3dPoint2& place) const;
  template <typename Points>
  void Open(lms3dFusedPlane& plane, const Points& points) const;

  const lms3dSeenRanges& Ranges;
  const double MaximumError;
  const bool Forgets;
  /// The plane in the sensor frame: its normal, and the sensor's distance in front of it.
  lms3dVector Normal = {};
  double Height = 0.0;
  std::vector<int> Bins;
  std::vector<int> BinsOfBlock;
  std::vector<bool> HasBin;
};

#endif
