// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dRayCaster.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dBuildStopped.h"
#include "Kernels/lms3dPacketKernels.h"

#include <iterator>
#include <limits>

using lms3dNewRayCaster = std::unique_ptr<lms3dRayCaster>(
  lms3dTriangleMesh mesh, const lms3dProgress& progress);

lms3dNewRayCaster lms3dNewExactCaster;
lms3dNewRayCaster lms3dNewFastCaster;
lms3dNewRayCaster lms3dNewAngleSumCaster;
lms3dNewRayCaster lms3dNewMollerTrumboreCaster;
lms3dNewRayCaster lms3dNewStaticCellLocatorCaster;

namespace
{
struct Method
{
  const char* Name;
  lms3dNewRayCaster* New;
};

constexpr Method Methods[] = {
  { "Exact", lms3dNewExactCaster },
  { "Fast", lms3dNewFastCaster },
  { "AngleSum", lms3dNewAngleSumCaster },
  { "MollerTrumbore", lms3dNewMollerTrumboreCaster },
  { "StaticCellLocator", lms3dNewStaticCellLocatorCaster },
};
static_assert(std::size(Methods) == lms3dRayCaster::STATIC_CELL_LOCATOR + 1,
  "the rows of this table have the order of lms3dRayCaster::Method");

/// Casts the packets of a scan like any others.
class PacketGridCaster final : public lms3dGridCaster
{
public:
  PacketGridCaster(const lms3dRayCaster& caster, const lms3dRayOrigin& origin)
    : Caster(caster)
    , Origin(origin)
  {
  }

  int GetRows() const override { return 1; }
  int GetColumns() const override { return MaximumPackets; }

  void FindNearest(const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const override
  {
    this->Caster.FindNearest(this->Origin, packets, rectangle.Rows * rectangle.Columns);
  }

private:
  const lms3dRayCaster& Caster;
  const lms3dRayOrigin Origin;
};

/// Calls `cast` with a packet of one active beam for each active beam of a packet, and keeps the
/// results.
template <typename Function>
void CastOneByOne(double maximumRange, lms3dFreePacket& packet, const Function& cast)
{
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    if (lms3dHasBit(packet.Active, beam))
    {
      const lms3dRayOrigin origin = {
        { packet.Origin[0][beam], packet.Origin[1][beam], packet.Origin[2][beam] }, maximumRange
      };
      lms3dBeamPacket alone = packet;
      alone.Active = 1u << beam;
      cast(origin, alone);
      packet.Range[beam] = alone.Range[beam];
      packet.Triangle[beam] = alone.Triangle[beam];
    }
  }
}
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dRayCaster::New(
  int method, lms3dTriangleMesh mesh, const lms3dProgress& progress)
{
  try
  {
    return Methods[method].New(std::move(mesh), progress);
  }
  catch (const lms3dBuildStopped&)
  {
    return nullptr;
  }
}

void lms3dRayCaster::RefineRanges(const lms3dRayOrigin&, lms3dBeamPacket*, int) const
{
  // The ranges of FindNearest are final.
}

void lms3dRayCaster::ComputeRanges(const lms3dRayOrigin&, lms3dBeamPacket*, int) const
{
  // FindNearest has set them.
}

void lms3dRayCaster::FindNearestFree(double maximumRange, lms3dFreePacket* packets, int count) const
{
  for (int i = 0; i < count; ++i)
  {
    lms3dGetPacketKernels().Free.NarrowDirections(packets[i]);
    CastOneByOne(maximumRange, packets[i],
      [this](const lms3dRayOrigin& origin, lms3dBeamPacket& packet)
      {
        this->FindNearest(origin, &packet, 1);
        this->ComputeRanges(origin, &packet, 1);
      });
  }
}

void lms3dRayCaster::RefineRangesFree(lms3dFreePacket* packets, int count) const
{
  for (int i = 0; i < count; ++i)
  {
    CastOneByOne(std::numeric_limits<double>::infinity(), packets[i],
      [this](const lms3dRayOrigin& origin, lms3dBeamPacket& packet)
      { this->RefineRanges(origin, &packet, 1); });
  }
}

std::unique_ptr<lms3dGridCaster> lms3dRayCaster::NewGridCaster(
  const lms3dRayOrigin& origin, const lms3dBeamGrid&) const
{
  return std::make_unique<PacketGridCaster>(*this, origin);
}

int lms3dRayCaster::GetNumberOfMethods()
{
  return static_cast<int>(std::size(Methods));
}

const char* lms3dRayCaster::GetMethodName(int method)
{
  return Methods[method].Name;
}
