// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeCandidates.h"
#include "Casting/lms3dRangeRefinement.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

namespace
{
/**
 * Embree finds candidates. Single precision rejects most of them; double precision with an error
 * bound decides on most others, and exact arithmetic on the beams for which the bound leaves a sign
 * open. Once the nearest triangle is known, its range is computed again with more digits.
 */
class ExactCaster final
  : public lms3dRayCaster
  , private lms3dCandidateTest
{
public:
  ExactCaster(lms3dTriangleMesh mesh, const lms3dProgress& progress)
    : lms3dRayCaster(std::move(mesh))
    , Kernels(lms3dGetPacketKernels())
    , Candidates(this->GetMesh(), *this, progress)
  {
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    this->Candidates.Cast(origin, packets, count);
  }

  void RefineRanges(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    lms3dRefineRanges(this->GetMesh(), origin, packets, count);
  }

private:
  std::uint32_t Test(
    const lms3dRayOrigin& origin, std::uint32_t candidate, lms3dBeamPacket& packet) const override
  {
    const lms3dCorners corners = lms3dGetCorners(this->GetMesh(), candidate);
    const lms3dSensorFrameTriangle inSensorFrame = lms3dToSensorFrame(corners, origin.Position);
    const lms3dHitMasks hitMasks = this->Kernels.Classify(inSensorFrame, packet);
    if (((hitMasks.Hit | hitMasks.Uncertain) & packet.Active) == 0)
    {
      return 0;
    }
    const std::int32_t triangle = static_cast<std::int32_t>(candidate);
    std::uint32_t uncertain = hitMasks.Uncertain & packet.Active;
    std::uint32_t changed = this->Kernels.UpdateNearest(inSensorFrame, triangle,
      hitMasks.Hit & packet.Active, origin.MaximumRange, packet, uncertain);
    if (uncertain != 0)
    {
      changed |=
        this->UpdateUncertain(corners, triangle, uncertain, hitMasks.Uncertain, origin, packet);
    }
    return changed;
  }

  // Updates the beams in `uncertain`: beams that need the exact test (mask `undecided`), and beams whose
  // range needs more digits than double precision gives.
  std::uint32_t UpdateUncertain(const lms3dCorners& corners, std::int32_t triangle,
    std::uint32_t uncertain, std::uint32_t undecided, const lms3dRayOrigin& origin,
    lms3dBeamPacket& packet) const
  {
    double ranges[lms3dBeamPacket::Size];
    const lms3dDoubleDoublePlane plane =
      this->Kernels.MakeDoubleDoublePlane(corners.data(), origin.Position);
    if (lms3dIsNearPlane(corners, origin.Position, plane))
    {
      lms3dIntersectNearPlane(corners, origin.Position, packet, ranges);
    }
    else
    {
      this->Kernels.IntersectDoubleDoublePlane(plane, packet, ranges);
    }
    std::uint32_t changed = 0;
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      const std::uint32_t bit = 1u << beam;
      const double range = ranges[beam];
      const bool isNearer = range < packet.Range[beam] ||
        (range == packet.Range[beam] && triangle < packet.Triangle[beam]);
      if ((uncertain & bit) && range > 0.0 && range <= origin.MaximumRange && isNearer &&
        (!(undecided & bit) || IsInside(corners, origin, beam, packet)))
      {
        packet.Range[beam] = range;
        packet.Triangle[beam] = triangle;
        changed |= bit;
      }
    }
    return changed;
  }

  static bool IsInside(const lms3dCorners& corners, const lms3dRayOrigin& origin, int beam,
    const lms3dBeamPacket& packet)
  {
    const double direction[3] = { packet.Direction[0][beam], packet.Direction[1][beam],
      packet.Direction[2][beam] };
    return lms3dIsInside(corners, origin.Position, direction);
  }

  const lms3dPacketKernels& Kernels;
  const lms3dEmbreeCandidates Candidates;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewExactCaster(
  lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  return std::make_unique<ExactCaster>(std::move(mesh), progress);
}
