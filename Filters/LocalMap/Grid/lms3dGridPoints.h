// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The coordinates of the returns of a range grid.
 */
#ifndef lms3dGridPoints_h
#define lms3dGridPoints_h

#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <array>

/// One padded grid for each coordinate, metres, so that compilers vectorize loops over a turn. The
/// caller chooses the frame. Coordinates are 0 without a return.
class lms3dGridPoints
{
public:
  /// Takes the shape of a range grid; see lms3dPaddedGrid::SetShape().
  void SetShape(const lms3dRangeGrid& grid)
  {
    for (lms3dPaddedGrid<double>& coordinates : this->OfAxis)
    {
      coordinates.SetShape(grid.GetNumberOfTurns(), grid.GetNumberOfBeams());
    }
  }

  /// To be called after all turns are filled; see lms3dPaddedGrid::FillHalo().
  void FillHalo(const lms3dRangeGrid& grid)
  {
    for (lms3dPaddedGrid<double>& coordinates : this->OfAxis)
    {
      coordinates.FillHalo(grid.IsClosed());
    }
  }

  ///@{
  /// The coordinates of a turn's returns along an axis, 0 to 2, by beam.
  double* GetRow(int axis, int turn) { return this->OfAxis[axis].GetRow(turn); }
  const double* GetRow(int axis, int turn) const { return this->OfAxis[axis].GetRow(turn); }
  ///@}

private:
  std::array<lms3dPaddedGrid<double>, 3> OfAxis;
};

#endif
