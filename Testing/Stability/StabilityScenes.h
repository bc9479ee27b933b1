// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scenes of the stability suite, and how beams are aimed at them.
 */
#ifndef StabilityScenes_h
#define StabilityScenes_h

#include "StabilityCase.h"

#include <cstddef>

/// What of its triangle a beam is aimed at; ANYTHING is each of the three for a third of the beams.
enum class StabilityAim
{
  CORNER,
  EDGE,
  INSIDE,
  ANYTHING
};

/// A ball of 1,280 triangles around the origin, and a place inside which is on none of its planes.
lms3dTriangleMesh MakeStabilityBall();
constexpr Vector InsideStabilityBall = { 0.1, 0.2, -0.3 };

/// Shots from one place at triangles here and there. The points are computed as they are seen from
/// there, so that no rounding but that of the direction moves the beam off an edge or a corner.
StabilityCase AimAtTriangles(const lms3dTriangleMesh& mesh, const Vector& sensor, StabilityAim aim,
  Random& random, std::size_t shots);

/// Shots from places in turn, in all directions.
StabilityCase AimAllAround(const lms3dTriangleMesh& mesh, const std::vector<Vector>& sensors,
  Random& random, std::size_t shots);

/// 80 triangles around the origin that touch nowhere.
lms3dTriangleMesh MakeLooseTriangles();

/// Shots from the origin that pass an edge of loose triangles at such a share of its length,
/// outside, or where that is below 0, inside.
StabilityCase AimBesideEdges(
  const lms3dTriangleMesh& mesh, double share, Random& random, std::size_t shots);

/// Shots along the side of a triangle beside two that end in the middle of it.
StabilityCase AimAtTJunction(Random& random, std::size_t shots);

/// Shots from places of a grid, out to `reach` of its spacings, to others of a grid that is `finer`
/// times as fine: all coordinates are short, so that beams meet edges and corners without any
/// rounding.
StabilityCase AimOnGrid(const lms3dTriangleMesh& mesh, int reach, double spacing, int finer,
  Random& random, std::size_t shots);

/// Shots at a wall of triangles that are `aspect` times longer than wide: at their sides and
/// within, away from the wall's border.
StabilityCase AimAtNeedles(double aspect, Random& random, std::size_t shots);

/// Shots from a height in metres above the middle of a square of 4 m x 4 m.
StabilityCase AimAlongFloor(double height, Random& random, std::size_t shots);

/// Shots within a ball; of each direction one component, x, y or z, is nothing but this.
StabilityCase AimAlongAxes(double component, Random& random, std::size_t shots);

#endif
