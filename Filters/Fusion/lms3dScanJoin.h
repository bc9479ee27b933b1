// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins the local map of a scan to the planes of a fused map.
 */
#ifndef lms3dScanJoin_h
#define lms3dScanJoin_h

#include "Fusion/lms3dFusedPlanes.h"
#include "Fusion/lms3dLocalMap.h"
#include "Fusion/lms3dPatchFit.h"

#include <array>
#include <vector>

/// Patches join planes that explain them, or become planes. Curved patches that the map explains already are left out.
/// The triangles of other patches become regions of their own if the map does not explain their returns.
class lms3dScanJoin
{
public:
  /// Keeps references.
  lms3dScanJoin(const lms3dLocalMap& local, const lms3dSeenRanges& ranges, lms3dFusedPlanes& planes)
    : Local(local)
    , Ranges(ranges)
    , Planes(planes)
  {
  }

  void Join();

private:
  int FindOrMakePlane(
    const std::vector<int>& returns, const lms3dFittedPlane& fit, std::size_t planesBefore);
  void AddTriangles(const std::vector<int>& planeOfPatch);
  int FindPlane(const std::vector<int>& returns, const lms3dFittedPlane& fit) const;
  bool IsMostlyExplained(const std::vector<lms3dMappedReturn>& returns, std::size_t end) const;
  void AddLoose(const std::vector<int>& returns, int ownPlane, std::vector<bool>& isExplained);
  int FindPlaneBeside(const std::vector<int>& returns, const std::array<lms3dVector, 3>& corners,
    const lms3dVector& normal) const;
  void AddTriangle(int triangle, const std::vector<int>& returns);
  void AddRest(const std::vector<bool>& isExplained, const std::vector<int>& planeOfPatch);

  const lms3dLocalMap& Local;
  const lms3dSeenRanges& Ranges;
  lms3dFusedPlanes& Planes;
};

#endif
