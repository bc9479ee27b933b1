// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeScene.h"
#include "Casting/lms3dRangeMeter.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"

#include <tbb/parallel_for.h>

#include <cstddef>

namespace
{
/// Embree's single-precision triangles decide; the range is that of the triangle's plane in
/// double.
class FastCaster final : public lms3dRayCaster
{
public:
  FastCaster(lms3dTriangleMesh mesh, const lms3dProgress& progress)
    : lms3dRayCaster(CollapseTrianglesWithoutArea(std::move(mesh)))
    , Scene(this->GetMesh(), progress)
  {
  }

  void Choose(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const override
  {
    this->Scene.Cast(viewpoint, packets, count);
    lms3dMeasureRangesRoughly(this->GetMesh(), viewpoint, packets, count);
  }

private:
  // Single precision may hit a line, which has no range to give; a point it never hits.
  static lms3dTriangleMesh CollapseTrianglesWithoutArea(lms3dTriangleMesh mesh)
  {
    tbb::parallel_for(std::size_t(0), mesh.GetNumberOfTriangles(),
      [&mesh](std::size_t i)
      {
        if (!lms3dHasArea(lms3dGetCorners(mesh, i)))
        {
          mesh.Triangles[i].fill(mesh.Triangles[i][0]);
        }
      });
    return mesh;
  }

  const lms3dEmbreeScene Scene;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewFastCaster(
  lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  return std::make_unique<FastCaster>(std::move(mesh), progress);
}
