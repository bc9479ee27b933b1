// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeTriangles.h"
#include "Casting/lms3dFreeRangeRefinement.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"

#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <utility>

namespace
{
/// Embree decides in single precision which triangle each beam hits. The range is the distance to
/// the plane of that triangle in double precision.
class FastCaster final : public lms3dRayCaster
{
public:
  FastCaster(lms3dTriangleMesh mesh, const lms3dProgress& progress)
    : lms3dRayCaster(std::move(mesh))
    , Indices(CollapseTrianglesWithoutArea(this->GetMesh()))
    , Triangles(this->GetMesh(), this->Indices.empty() ? this->GetMesh().Triangles : this->Indices,
        progress)
  {
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    this->Triangles.Cast(origin, packets, count);
    lms3dRefineRangesInDouble(this->GetMesh(), origin, packets, count);
  }

  void FindNearestFree(double maximumRange, lms3dFreePacket* packets, int count) const override
  {
    this->Triangles.CastFree(maximumRange, packets, count);
    lms3dRefineFreeRangesInDouble(this->GetMesh(), maximumRange, packets, count);
  }

  void RefineRangesFree(lms3dFreePacket*, int) const override
  {
    // The ranges of FindNearestFree are final.
  }

private:
  // In single precision a beam may hit a triangle that has no area but a length; its plane gives no
  // range. A triangle collapsed to a point is never hit. Returns an empty list if all have an area:
  // Embree then shares the indices of the mesh.
  static lms3dTriangleIndices CollapseTrianglesWithoutArea(const lms3dTriangleMesh& mesh)
  {
    tbb::concurrent_vector<std::size_t> flat;
    tbb::parallel_for(std::size_t(0), mesh.GetNumberOfTriangles(),
      [&](std::size_t i)
      {
        if (!lms3dHasArea(lms3dGetCorners(mesh, i)))
        {
          flat.push_back(i);
        }
      });
    lms3dTriangleIndices indices;
    if (!flat.empty())
    {
      indices = mesh.Triangles;
    }
    for (std::size_t i : flat)
    {
      indices[i].fill(indices[i][0]);
    }
    return indices;
  }

  const lms3dTriangleIndices Indices;
  const lms3dEmbreeTriangles Triangles;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewFastCaster(
  lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  return std::make_unique<FastCaster>(std::move(mesh), progress);
}
