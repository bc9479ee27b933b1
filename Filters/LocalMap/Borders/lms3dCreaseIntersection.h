// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A point in a cell of four beams that moves to where planes meet.
 */
#ifndef lms3dCellSlide_h
#define lms3dCellSlide_h

#include "Triangulation/lms3dOrientation.h"

#include <array>

/**
 * By Gauss and Newton's steps: between the corners of a cell, clockwise from the lower left one, the
 * differences of two planes' inverse ranges are bilinear.
 */
class lms3dCreaseIntersection
{
public:
  /// The differences of two planes' inverse ranges at the corners; no more than four times.
  void AddCrease(const std::array<double, 4>& differences)
  {
    this->Creases[this->Count++] = differences;
  }

  /// By so much of the cell's width and height, but not out of it.
  void Move(const lms3dPoint2& offset);

  /// From where the point is to the nearest point on all creases, as far as there is one.
  void Run();

  /// Of the corners, at the point.
  std::array<double, 4> GetWeights() const;

private:
  void Step();

  lms3dPoint2 At = { 0.5, 0.5 };
  std::array<std::array<double, 4>, 4> Creases;
  int Count = 0;
};

#endif
