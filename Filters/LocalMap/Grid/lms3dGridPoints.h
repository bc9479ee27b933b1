// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The coordinates of the returns at their places in the grid.
 */
#ifndef lms3dGridPoints_h
#define lms3dGridPoints_h

#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <array>

/// A grid for each coordinate, so that loops over a turn are vectorized; 0 where there is no return.
class lms3dGridPoints
{
public:
  /// As for lms3dPaddedGrid.
  void SetShape(const lms3dRangeGrid& grid)
  {
    for (lms3dPaddedGrid<double>& coordinates : this->OfAxis)
    {
      coordinates.SetShape(grid.GetNumberOfTurns(), grid.GetNumberOfBeams());
    }
  }

  void FillHalo(const lms3dRangeGrid& grid)
  {
    for (lms3dPaddedGrid<double>& coordinates : this->OfAxis)
    {
      coordinates.FillHalo(grid.IsClosed());
    }
  }

  double* GetRow(int axis, int turn) { return this->OfAxis[axis].GetRow(turn); }
  const double* GetRow(int axis, int turn) const { return this->OfAxis[axis].GetRow(turn); }

private:
  std::array<lms3dPaddedGrid<double>, 3> OfAxis;
};

#endif
