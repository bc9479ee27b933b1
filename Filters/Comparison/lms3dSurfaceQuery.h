// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the nearest triangle of a surface, and the range at which a beam hits the surface.
 */
#ifndef lms3dSurfaceQuery_h
#define lms3dSurfaceQuery_h

#include "Casting/lms3dBuildStopped.h"
#include "Casting/lms3dEmbreeTriangles.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

#include <cstdint>
#include <limits>
#include <vector>

/// The triangle nearest to a point. At equal distances, the triangle with the lowest index.
struct lms3dNearest
{
  /// Metres.
  double Distance = std::numeric_limits<double>::infinity();
  std::uint32_t Triangle = 0;
};

/// Both queries use the threads of the calling TBB arena. The results do not depend on the number
/// of threads. The queries and the constructor throw lms3dBuildStopped if `progress` stopped them.
class lms3dSurfaceQuery
{
public:
  /// World coordinates, metres.
  using Points = std::vector<lms3dVector>;

  /// Takes the mesh over, which must have at least one triangle and none without area.
  lms3dSurfaceQuery(lms3dTriangleMesh mesh, const lms3dProgress& progress);

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

  /// Returns the nearest triangle of each point. Distances are exact within the rounding of double,
  /// and infinite for a point that is not finite.
  std::vector<lms3dNearest> FindNearest(const Points& points, const lms3dProgress& progress) const;

  /**
   * Casts a beam from `origin` towards each point. Returns the range of the first hit in metres. It
   * is infinite without a hit, if the point is at the origin, or if one of both is not finite.
   * Single precision decides which triangle is hit: a beam that passes an edge within 1e-6 of the
   * surface's size may hit the triangle on the other side, and one that passes a corner, none.
   */
  std::vector<double> GetRangesTowards(
    const lms3dVector& origin, const Points& points, const lms3dProgress& progress) const;

  /// The same for beams with an origin each.
  std::vector<double> GetRangesTowards(
    const Points& origins, const Points& points, const lms3dProgress& progress) const;

private:
  lms3dNearest FindNearest(const lms3dVector& point, std::uint32_t guess) const;

  const lms3dTriangleMesh Mesh;
  const lms3dEmbreeTriangles Triangles;
  const lms3dRangeRefinement Refinement;
};

#endif
