// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the beams of a scan passed through a plane.
 */
#ifndef lms3dPassages_h
#define lms3dPassages_h

#include "Fusion/Planes/lms3dBlockGroups.h"
#include "Fusion/Planes/lms3dFusedPlane.h"
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <cstddef>
#include <vector>

/// Where a beam passed, cells.
struct lms3dPassage
{
  bool IsPassed = false;
  lms3dPoint2 Place = {};
};

/// Keeps memory from plane to plane.
class lms3dPassages
{
public:
  /// A beam passed if it is free beyond the plane by more than `maximumError`, metres.
  explicit lms3dPassages(double maximumError)
    : MaximumError(maximumError)
  {
  }

  /// Finds all beams that passed through groups of blocks of a plane, and some that passed beside
  /// them. Keeps references to the ranges and the plane.
  void Find(
    const lms3dSeenRanges& ranges, const lms3dFusedPlane& plane, const lms3dBlockGroups& groups);

  std::size_t GetSize() const { return this->Beams.size(); }
  int GetBeam(std::size_t i) const { return this->Beams[i]; }
  const lms3dPoint2& GetPlace(std::size_t i) const { return this->Places[i]; }

  /// Where any beam passed.
  lms3dPassage Get(int beamId) const;

private:
  class QuickLook;

  void Forget();
  void FindBins(const lms3dBlockGroups& groups);
  void FindInBins(const lms3dBlockGroup& blocks);
  void FindAt(const QuickLook& look, int firstPlace, int endOfPlaces);
  lms3dPassage Look(int beamId) const;

  const double MaximumError;
  const lms3dSeenRanges* Ranges = nullptr;
  const lms3dFusedPlane* Plane = nullptr;
  /// The bins of the beams that were looked at.
  std::vector<int> Bins;
  std::vector<int> BinsOfGroup;
  std::vector<char> HasBin;
  /// The beams of these bins that passed, and the place of each.
  std::vector<int> Beams;
  std::vector<lms3dPoint2> Places;
  /// The number of each beam among them, -1 for others.
  std::vector<int> Numbers;
};

#endif
