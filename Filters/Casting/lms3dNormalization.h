// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves a scene to the origin and scales it to a diagonal of 1.
 *
 * Single precision then costs no more digits at a large offset, or at a very small or large scale,
 * than it does anywhere.
 */
#ifndef lms3dNormalization_h
#define lms3dNormalization_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>
#include <vector>

class lms3dNormalization
{
public:
  /// Some triangles, in increasing order, may be left out; at least one must be left.
  explicit lms3dNormalization(
    const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& leftOut = {});

  double Normalize(double coordinate, int axis) const
  {
    return (coordinate - this->Center[axis]) / this->Diagonal;
  }

  double GetCoordinate(const double* point, int axis) const
  {
    return this->Normalize(point[axis], axis);
  }

  double GetCenter(int axis) const { return this->Center[axis]; }
  double GetDiagonal() const { return this->Diagonal; }
  double GetDistance(double range) const { return range / this->Diagonal; }

  /// How far along its beam a ray may start, metres, so that it starts within a few diagonals.
  double GetHeadStart(const double origin[3]) const;

  /// The directions in which the scene may be seen, and a little more; all from within.
  lms3dCone GetCone(const double origin[3]) const;

private:
  double Center[3];
  double Diagonal;
};

#endif
