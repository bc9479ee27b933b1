// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges of fans as if the platform stood still during each.
 */
#ifndef lms3dSteadyFans_h
#define lms3dSteadyFans_h

#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Grid/lms3dPaddedGrid.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <cstdint>

/**
 * While the platform turns, the beams of a fan leave at various platform angles, and interlaced
 * neighbours at angles that are far apart. So a fan does not lie in a plane, and its ranges on a
 * wall form a comb. This class interpolates each beam's inverse range between two turns to the
 * angle at which its fan started. On a plane, the inverse range along a turn is nearly linear.
 */
class lms3dSteadyFans
{
public:
  /// Keeps references. `joins` has the flags lms3dRangeJoins::AlongTurn of all turns.
  lms3dSteadyFans(const lms3dRangeGrid& grid, const lms3dMapGeometry& geometry,
    const lms3dPaddedGrid<std::uint8_t>& joins)
    : Grid(grid)
    , Geometry(geometry)
    , Joins(joins)
  {
  }

  /// Fills the ranges of a turn, metres, 0 without a return, from beam -2 to two beams behind the
  /// last. If the two turns are not on one surface, the range stays as it is.
  void Fill(int turn, double* ranges) const;

private:
  double GetRange(int turn, int beam, double turnedSteps) const;

  const lms3dRangeGrid& Grid;
  const lms3dMapGeometry& Geometry;
  const lms3dPaddedGrid<std::uint8_t>& Joins;
};

#endif
