// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins neighbouring returns by triangles where they lie on one surface.
 */
#ifndef lms3dGridMesher_h
#define lms3dGridMesher_h

#include "lms3dRangeGrid.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Two triangles for each cell of the grid, along its shorter diagonal, one for each cell at a pole.
 * A triangle is made where both of its sides along the grid join returns of one surface.
 *
 * Neighbours a and b belong to one surface where their ranges differ by no more than the tolerance,
 * or where the plane through a and the return before it meets b's beam within the tolerance of b
 * (or the same from b's side): so a floor that is met at a grazing angle stays whole, however far
 * apart its returns are. On a plane, neighbours w of 1/range obey w[i-1] + w[i+1] = 2 cos(step)
 * w[i]; that is exact along a fan, and along a turn for planes that are level or upright.
 *
 * The tolerance is `depthStep` (metres) plus a share of the nearer range: 2 % or, where neighbours
 * are farther apart, the angle between them in radians, so that a coarse scan joins what leans by
 * 45 degrees as well.
 */
class lms3dGridMesher
{
public:
  using Triangle = std::array<std::int64_t, 3>;

  /// `points` are the coordinates of the scan's returns, three for each.
  lms3dGridMesher(const lms3dRangeGrid& grid, const double* points, double depthStep);

  /// Triangles of the grid's vertices, facing the sensor, ordered by turn, then beam.
  std::vector<Triangle> MakeTriangles() const;

private:
  struct Cell;

  /// How neighbours along a fan, or along a turn, are compared.
  struct Spacing
  {
    explicit Spacing(double stepInDegrees);

    double TwoCosines;
    double RelativeDepthStep;
  };

  void AppendStrip(int turn, std::vector<Triangle>& out) const;
  void AppendCell(const Cell& cell, std::vector<Triangle>& out) const;
  Cell GetCell(int turn, int beam) const;
  bool IsJoinedAlongFan(int turn, int beam) const;
  bool IsJoinedAlongTurn(int turn, int beam) const;
  bool IsJoined(const std::array<double, 4>& ranges, const Spacing& spacing) const;
  double GetSquaredDistance(std::int64_t a, std::int64_t b) const;

  const lms3dRangeGrid& Grid;
  const double* Points;
  const double DepthStep;
  const Spacing AlongFan;
  const Spacing AlongTurn;
};

#endif
