// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The point of a cell at which its creases meet.
 */
#ifndef lms3dCreaseIntersection_h
#define lms3dCreaseIntersection_h

#include "Triangulation/lms3dOrientation.h"

#include <array>

/**
 * Finds the least-squares intersection of up to four creases in a cell of lms3dBorderGates, by the
 * Gauss-Newton method. Between the corners of the cell, the difference of two planes' inverse
 * ranges is bilinear; a crease is where it is 0. The search starts in the middle of the cell.
 *
 * Coordinates in the cell are 0 to 1, x to the right and y upwards. The point keeps a margin of
 * 0.1 from the cell's sides. Corners are numbered clockwise from the lower left.
 */
class lms3dCreaseIntersection
{
public:
  /// Takes the difference of two planes' inverse ranges at each corner, 1/metre. At most four
  /// calls.
  void AddCrease(const std::array<double, 4>& differences)
  {
    this->Creases[this->Count++] = differences;
  }

  /// Moves the point by an offset, in cell coordinates.
  void Move(const lms3dPoint2& offset);

  /// Moves the point to the nearest point on all creases, or as near to them as it can come.
  /// Without a crease, the point stays.
  void Solve();

  /// The bilinear weights of the corners at the point.
  std::array<double, 4> GetWeights() const;

private:
  void Step();

  lms3dPoint2 Point = { 0.5, 0.5 };
  std::array<std::array<double, 4>, 4> Creases;
  int Count = 0;
};

#endif
