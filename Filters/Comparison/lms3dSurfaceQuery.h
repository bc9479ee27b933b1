// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A surface that tells how far it is from points, and where beams meet it.
 */
#ifndef lms3dSurfaceQuery_h
#define lms3dSurfaceQuery_h

#include "Casting/lms3dBuildStopped.h"
#include "Casting/lms3dEmbreeTriangles.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

/// The triangle nearest to a point; of several at the same distance the one with the least number.
struct lms3dNearest
{
  /// Metres.
  double Distance = std::numeric_limits<double>::infinity();
  std::uint32_t Triangle = 0;
};

/// Both questions use the threads of the calling TBB arena; the answers do not depend on their
/// number.
class lms3dSurfaceQuery
{
public:
  using Points = std::vector<std::array<double, 3>>;

  /// Takes the mesh over, which must have at least one triangle and none without area. `progress`
  /// may be empty; the constructor throws lms3dBuildStopped if `progress` stopped the build.
  explicit lms3dSurfaceQuery(lms3dTriangleMesh mesh, const lms3dProgress& progress = {});

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

  /// Within the rounding of double, whatever is inside, on an edge or beside the triangle. A point
  /// that is not finite is infinitely far from everything.
  std::vector<lms3dNearest> FindNearest(const Points& points) const;

  /**
   * For each point the range at which the beam from `origin` towards it meets the surface first,
   * metres; infinite where it meets none. A beam within 1e-6 of the surface's size from an edge may
   * be given to the wrong side of it.
   */
  std::vector<double> GetRangesTowards(const double origin[3], const Points& points) const;

private:
  lms3dNearest FindNearest(const double point[3], std::uint32_t guess) const;
  void CastTowards(const lms3dRayOrigin& origin, const std::array<double, 3>* points, int count,
    double* ranges) const;

  const lms3dTriangleMesh Mesh;
  const lms3dEmbreeTriangles Triangles;
};

#endif
