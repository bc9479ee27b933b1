// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeScene.h"
#include "Casting/lms3dRangeMeter.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

namespace
{
/**
 * Embree finds candidates; float rejects most of them, double with an error bound decides, and
 * arithmetic without rounding where the bound leaves a sign open. The range is measured anew once
 * the nearest triangle is known.
 */
class ExactCaster final
  : public lms3dRayCaster
  , private lms3dEmbreeScene::CandidateTest
{
public:
  ExactCaster(lms3dTriangleMesh mesh, const lms3dProgress& progress)
    : lms3dRayCaster(std::move(mesh))
    , Kernels(lms3dGetPacketKernels())
    , Scene(this->GetMesh(), *this, progress)
  {
  }

  void Choose(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const override
  {
    this->Scene.Cast(viewpoint, packets, count);
  }

  void Measure(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const override
  {
    lms3dMeasureRanges(this->GetMesh(), viewpoint, packets, count);
  }

private:
  std::uint32_t Test(const lms3dViewpoint& viewpoint, std::uint32_t candidate,
    lms3dBeamPacket& packet) const override
  {
    const lms3dCorners corners = lms3dGetCorners(this->GetMesh(), candidate);
    const lms3dSeenTriangle seen = lms3dSee(corners, viewpoint.Origin);
    const lms3dVerdicts verdicts = this->Kernels.Classify(seen, packet);
    if (((verdicts.Hit | verdicts.Doubt) & packet.Active) == 0)
    {
      return 0;
    }
    const std::int32_t triangle = static_cast<std::int32_t>(candidate);
    std::uint32_t unsure = verdicts.Doubt & packet.Active;
    std::uint32_t changed = this->Kernels.TakeHits(
      seen, triangle, verdicts.Hit & packet.Active, viewpoint.MaximumRange, packet, unsure);
    if (unsure != 0)
    {
      changed |= this->TakeUnsure(corners, triangle, unsure, verdicts.Doubt, viewpoint, packet);
    }
    return changed;
  }

  // Beams whose sign is in doubt, and those whose range double would spoil.
  std::uint32_t TakeUnsure(const lms3dCorners& corners, std::int32_t triangle, std::uint32_t unsure,
    std::uint32_t doubt, const lms3dViewpoint& viewpoint, lms3dBeamPacket& packet) const
  {
    double ranges[lms3dBeamPacket::Size];
    const lms3dSeenPlane plane = this->Kernels.See(corners.data(), viewpoint.Origin);
    if (lms3dIsNearPlane(corners, viewpoint.Origin, plane))
    {
      lms3dMeasureNearPlane(corners, viewpoint.Origin, packet, ranges);
    }
    else
    {
      this->Kernels.Measure(plane, packet, ranges);
    }
    std::uint32_t changed = 0;
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      const std::uint32_t bit = 1u << beam;
      const double range = ranges[beam];
      const bool isNearer = range < packet.Range[beam] ||
        (range == packet.Range[beam] && triangle < packet.Triangle[beam]);
      if ((unsure & bit) && range > 0.0 && range <= viewpoint.MaximumRange && isNearer &&
        (!(doubt & bit) || IsInside(corners, viewpoint, beam, packet)))
      {
        packet.Range[beam] = range;
        packet.Triangle[beam] = triangle;
        changed |= bit;
      }
    }
    return changed;
  }

  static bool IsInside(const lms3dCorners& corners, const lms3dViewpoint& viewpoint, int beam,
    const lms3dBeamPacket& packet)
  {
    const double direction[3] = { packet.Direction[0][beam], packet.Direction[1][beam],
      packet.Direction[2][beam] };
    return lms3dIsInside(corners, viewpoint.Origin, direction);
  }

  const lms3dPacketKernels& Kernels;
  const lms3dEmbreeScene Scene;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewExactCaster(
  lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  return std::make_unique<ExactCaster>(std::move(mesh), progress);
}
