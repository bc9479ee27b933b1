// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Adds the returns of a scan that the planes of their patches do not explain.
 */
#ifndef lms3dLooseReturns_h
#define lms3dLooseReturns_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Returns/lms3dSparseParts.h"
#include "Fusion/Scans/lms3dLocalMap.h"

#include <array>
#include <vector>

/// Keeps references. `isExplained` has a number for each return of the local map, 0 if no plane
/// explains it.
class lms3dLooseReturns
{
public:
  lms3dLooseReturns(const lms3dLocalMap& local, lms3dFusedPlanes& planes)
    : Local(local)
    , Planes(planes)
  {
  }

  /// Adds each of some returns of a patch to the plane that is nearest to it.
  void AddToNearest(const std::vector<int>& returns, int ownPlane, std::vector<char>& isExplained);

  /// Adds all returns that are not explained. `planeOfPatch` has the plane of each patch, -1 for
  /// none. Returns on sparse triangles get facets.
  void AddRest(const std::vector<char>& isExplained, const std::vector<int>& planeOfPatch,
    const lms3dSparseParts& sparse);

private:
  int FindPlaneBeside(const std::vector<int>& returns, const std::array<lms3dVector, 3>& corners,
    const lms3dVector& normal) const;
  void AddTriangle(int triangle, const std::vector<int>& returns);

  const lms3dLocalMap& Local;
  lms3dFusedPlanes& Planes;
};

#endif
