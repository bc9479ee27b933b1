// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves a scene's centre to the origin and scales its diagonal to 1.
 *
 * Single precision then keeps the same number of digits of a scene at any offset and scale. Lengths
 * and coordinates are in metres, in the world frame, unless a comment says "normalized".
 */
#ifndef lms3dNormalization_h
#define lms3dNormalization_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>
#include <vector>

/// In normalized coordinates.
struct lms3dNormalizedBox
{
  float Low[3];
  float High[3];
};

/// Returns the smallest box that has both.
lms3dNormalizedBox lms3dJoin(const lms3dNormalizedBox& a, const lms3dNormalizedBox& b);

class lms3dNormalization
{
public:
  /// Takes the bounds of the mesh without the `excluded` triangles, which are in increasing order.
  /// At least one triangle must remain. Uses the threads of the calling TBB arena.
  explicit lms3dNormalization(
    const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded = {});

  /// Returns one normalized coordinate of a point.
  double NormalizeCoordinate(const double* point, int axis) const
  {
    return (point[axis] - this->Center[axis]) / this->Diagonal;
  }

  /// Returns a box around a triangle, larger by more than the rounding of single precision: of
  /// vertices, ray origins and directions, and in traversal, as long as rays start within a few
  /// diagonals.
  lms3dNormalizedBox GetBox(const lms3dCorners& corners) const;

  double GetCenter(int axis) const { return this->Center[axis]; }
  double GetDiagonal() const { return this->Diagonal; }

  /// Returns a normalized length.
  double NormalizeLength(double length) const { return length / this->Diagonal; }

  /// Returns how far along its beam a ray may start without passing the scene: 0 near the scene.
  /// Rays that can hit then start within two and a half diagonals of the centre.
  double GetRayOffset(const double origin[3]) const;

  /// Returns a cone that contains the scene's bounding sphere; from inside that sphere, all
  /// directions.
  lms3dCone GetCone(const double origin[3]) const;

private:
  double Center[3];
  double Diagonal;
};

#endif
