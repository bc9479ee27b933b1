// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The normals of a scene's triangles, and the angles at which beams meet them.
 */
#ifndef lms3dSurfaceNormals_h
#define lms3dSurfaceNormals_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

#include <cstdint>
#include <vector>

/// Computes unit normals, and keeps recent ones, because neighbouring beams hit the same triangles.
/// For one thread.
class lms3dSurfaceNormals
{
public:
  /// The mesh must outlive the object.
  explicit lms3dSurfaceNormals(const lms3dTriangleMesh& mesh);

  /// Returns the normal on the side from which the corners are counter-clockwise.
  const lms3dVector& Get(std::int32_t triangle);

  /// Returns the normal towards a position, world coordinates, metres. If the triangle's plane
  /// contains the position, this is the same as Get.
  lms3dVector GetFacing(std::int32_t triangle, const lms3dVector& position);

private:
  lms3dVector Compute(std::int32_t triangle) const;

  const lms3dTriangleMesh& Mesh;
  std::vector<std::int32_t> Triangles;
  std::vector<lms3dVector> Normals;

  ///@{
  /// The last arguments of GetFacing, and whether the normal is the opposite of Get.
  std::int32_t FacingTriangle;
  lms3dVector FacingPosition{};
  bool IsOpposite = false;
  ///@}
};

/// Returns the angle between a beam and a normal, degrees, 0 to 90. Both sides of a surface count.
double lms3dGetIncidence(const lms3dVector& direction, const lms3dVector& normal);

/// Returns the cosine of this angle. Both vectors must have the length 1.
inline double lms3dGetIncidenceCosine(const lms3dVector& direction, const lms3dVector& normal)
{
  return std::abs(lms3dDot(direction, normal));
}

#endif
