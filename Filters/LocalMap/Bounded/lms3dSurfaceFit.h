// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fits the ranges of all vertices of a map to the returns, within the bound.
 */
#ifndef lms3dSurfaceFit_h
#define lms3dSurfaceFit_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"
#include "LocalMap/Bounded/lms3dTriangleSums.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Vertices move along their directions, so that the sum of the squared distances of the returns
 * from the map, along their beams, becomes as small as the bound allows.
 *
 * On a triangle, the inverse range is linear in the inverse ranges of its corners. So the sum is
 * quadratic in the inverse ranges of all vertices, and each triangle adds to it what
 * lms3dTriangleSums finds. A few rounds of Gauss and Seidel's method come near its minimum. Then
 * the corners of some triangles move half of their way back, and at the third time all of it: if
 * the triangle leaves the bound of a return, or if it is at a depth step and the returns do not
 * support its new range there (lms3dBorderShortcuts). So the surface bridges no depth step. This
 * ends when all triangles that have moved are allowed.
 *
 * A vertex stays if no beam near it determines its range, or if it would move by less than a
 * hundredth of the bound.
 */
class lms3dSurfaceFit
{
public:
  /// Keeps references. `isChosen` is 1 for the vertices to fit, by vertex; the others stay.
  /// `maximumError` is the bound, metres.
  lms3dSurfaceFit(const lms3dBeamDemands& demands, const lms3dBorderShortcuts& borders,
    double maximumError, std::vector<std::uint8_t> isChosen, lms3dVertexStars& stars);

  /// Moves the vertices. Uses the threads of the calling TBB arena.
  void Run();

private:
  using Corners = std::array<std::int32_t, 3>;

  void AddUpTriangles();
  void FindMovable();
  void Minimize();
  double GetBest(std::int32_t vertex) const;
  lms3dTriangleSums::Triangle GetTriangle(std::size_t number) const;
  void ForgetSmallMoves();
  bool HasMoved(std::int32_t vertex) const
  {
    return this->Inverses[vertex] != this->Before[vertex];
  }
  bool IsAllowed(std::int32_t triangle) const;
  bool IsBorder(std::int32_t from, std::int32_t to) const;
  bool IsSupported(std::int32_t from, std::int32_t to) const;
  void MoveForbiddenBack();
  std::vector<std::int32_t> FindForbidden(const std::vector<std::int32_t>& triangles) const;
  std::vector<std::int32_t> MoveBack(const std::vector<std::int32_t>& triangles);
  void MoveVertices();

  const lms3dBeamDemands& Demands;
  const lms3dBorderShortcuts& Borders;
  const double MaximumError;
  lms3dVertexStars& Stars;
  /// By triangle.
  std::vector<lms3dTriangleSums> Sums;
  ///@{
  /// By vertex: the inverse range before the fit and after it, 1/metre.
  std::vector<double> Before;
  std::vector<double> Inverses;
  ///@}
  /// By vertex, 1 or 0: whether it may move.
  std::vector<std::uint8_t> IsMovable;
  /// By vertex: how often it has moved back.
  std::vector<std::uint8_t> MovesBack;
};

#endif
