// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the bounded map of a scan that planar patches would not simplify.
 */
#ifndef lms3dFacetedGrid_h
#define lms3dFacetedGrid_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

/**
 * Makes the triangles of the plain grid, with each return as a vertex, and a facet for each return
 * that belongs to no triangle. The deviation of every return is 0, except at poles.
 */
class lms3dFacetedGrid
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// Keeps references. `sphere` must be made of the same grid and joins.
  lms3dFacetedGrid(
    const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, const lms3dBeamSphere& sphere)
    : Grid(grid)
    , Joins(joins)
    , Sphere(sphere)
  {
  }

  /// Uses the threads of the calling TBB arena.
  lms3dBoundedMap MakeMap() const;

private:
  std::vector<GridIndex> FindIndices() const;
  std::vector<std::int32_t> MakeTriangles(const lms3dBoundedMap& map) const;
  std::vector<bool> AddTriangles(lms3dBoundedMap& map) const;

  const lms3dRangeGrid& Grid;
  const lms3dRangeJoins& Joins;
  const lms3dBeamSphere& Sphere;
};

#endif
