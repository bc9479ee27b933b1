// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dEmbreeScene.h"
#include "lms3dRangeMeter.h"
#include "lms3dRayCaster.h"

namespace
{
/// Embree's single-precision triangles decide; the range is that of the triangle's plane in
/// double.
class FastCaster final : public lms3dRayCaster
{
public:
  explicit FastCaster(lms3dTriangleMesh mesh)
    : lms3dRayCaster(std::move(mesh))
    , Scene(this->GetMesh())
  {
  }

  void Cast(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const override
  {
    this->Scene.Cast(viewpoint, packets, count);
    lms3dMeasureRangesRoughly(this->GetMesh(), viewpoint, packets, count);
  }

private:
  const lms3dEmbreeScene Scene;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewFastCaster(lms3dTriangleMesh mesh)
{
  return std::make_unique<FastCaster>(std::move(mesh));
}
