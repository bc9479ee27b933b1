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

#include <tbb/tbb_allocator.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Vertices move along their directions, so that the sum of the squared distances of the returns
 * from the map, with the areas of their beams as weights, becomes smaller. If it does not, all
 * vertices stay.
 *
 * On a triangle, the inverse range is linear in the inverse ranges of its corners. So the sum is
 * quadratic in the inverse ranges of all vertices, and each triangle adds to it what
 * lms3dTriangleSums finds. A few rounds of Gauss and Seidel's method come near its minimum. Then
 * some vertices move back, in rounds, half of their way, and at the third time all of it:
 *
 * - the ends of a border at a depth step, if the returns do not support its new ranges there
 *   (lms3dBorderShortcuts), so that the surface bridges no depth step, and
 * - the corners of a triangle that leaves the bound of a return.
 *
 * This ends when all triangles that have moved are allowed. Vertices that did not move back keep
 * their ranges, so the sum does not reach the minimum within the bound.
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

  /// A bit for each corner of a triangle.
  static constexpr std::uint8_t AllCorners = 7;

  void AddUpTriangles();
  void FindMovable();
  bool IsAtMoved(std::size_t triangle) const;
  void Minimize();
  double GetBest(std::int32_t vertex) const;
  lms3dTriangleBeams FindBeams(std::size_t triangle) const;
  std::array<double, 3> GetInverses(std::size_t triangle) const;
  void ForgetSmallMoves();
  bool HasMoved(std::int32_t vertex) const
  {
    return this->Inverses[vertex] != this->Before[vertex];
  }
  bool IsBorder(std::int32_t from, std::int32_t to) const;
  lms3dBorderShortcuts::Support GetSupport(std::int32_t from, std::int32_t to) const;
  void MoveForbiddenBack();
  std::vector<std::int32_t> FindForbidden(const std::vector<std::int32_t>& triangles);
  std::uint8_t FindForbiddenCorners(std::int32_t triangle);
  std::uint8_t FindUnsupportedEnds(std::int32_t triangle);
  std::vector<std::int32_t> MoveBack(const std::vector<std::int32_t>& vertices);
  double GetSum(const std::vector<double>& inverses) const;
  void MoveVertices();

  const lms3dBeamDemands& Demands;
  const lms3dBorderShortcuts& Borders;
  const double MaximumError;
  lms3dVertexStars& Stars;
  ///@{
  /// By triangle, for those with a chosen corner. The beams take about 100 bytes for each triangle
  /// and 12 for each of its columns, until the fit ends. TBB keeps this memory for the next fit
  /// (lms3dBeamVector.h).
  std::vector<lms3dTriangleBeams, tbb::tbb_allocator<lms3dTriangleBeams>> Beams;
  std::vector<lms3dTriangleSums, tbb::tbb_allocator<lms3dTriangleSums>> Sums;
  ///@}
  /// By triangle, a bit for each corner: whether the edge to the next corner can be a border at a
  /// depth step. The first check of an edge decides it.
  std::vector<std::uint8_t> MayBeSteps;
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
