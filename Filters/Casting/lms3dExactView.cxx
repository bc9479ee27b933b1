// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dExactView.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangle.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Enough for the preparations of a task to cost little.
constexpr std::size_t TrianglesOfTask = 64;

float RoundUp(double x)
{
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

bool IsInside(const lms3dCorners& corners, const lms3dRayOrigin& origin, int beam,
  const lms3dBeamPacket& packet)
{
  return lms3dIsInside(corners, origin.Position, lms3dGetDirection(packet, beam).data());
}
} // namespace

lms3dExactView::lms3dExactView(
  const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin, double unit)
  : Mesh(mesh)
  , Origin(origin)
  , Unit(unit)
  , MinimumInverse(RoundUp(unit / origin.MaximumRange))
{
}

void lms3dExactView::MakeNarrowTriangles()
{
  this->AllocateNarrowTriangles();
  const std::size_t count = this->Mesh.GetNumberOfTriangles();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, TrianglesOfTask),
    [this](const tbb::blocked_range<std::size_t>& range)
    { this->MakeNarrowTriangles(range.begin(), range.end()); });
}

void lms3dExactView::AllocateNarrowTriangles()
{
  // A vector would write zeros first.
  this->NarrowTriangles.reset(new lms3dNarrowTriangle[this->Mesh.GetNumberOfTriangles()]);
}

void lms3dExactView::MakeNarrowTriangles(std::size_t begin, std::size_t end)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    this->NarrowTriangles[i] = this->MakeNarrowTriangle(i);
  }
}

lms3dNarrowTriangle lms3dExactView::MakeNarrowTriangle(std::size_t triangle) const
{
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  return this->Kernels.MakeNarrowTriangle(
    lms3dToSensorFrame(corners, this->Origin.Position), this->Unit);
}

void lms3dExactView::Begin(lms3dBeamPacket& packet, lms3dPacketSearch& search) const
{
  // Beyond the maximum range, nothing is a hit. Near it, the bound leaves the decision to double.
  const float inverse = this->MinimumInverse;
  std::fill_n(search.Hits.InverseRange, lms3dBeamPacket::Size, inverse);
  std::fill_n(search.Hits.Error, lms3dBeamPacket::Size, lms3dNarrowError * inverse);
  lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packet);
  search.HaveRange = ~0u;
  search.Packet = &packet;
}

std::uint32_t lms3dExactView::Test(
  std::uint32_t triangle, std::uint32_t beams, lms3dPacketSearch& search) const
{
  const std::int32_t number = static_cast<std::int32_t>(triangle);
  lms3dNarrowMasks masks = { 0, beams };
  if (this->NarrowTriangles || search.Kept)
  {
    const lms3dNarrowTriangle& narrow = this->GetNarrowTriangle(number, search.Kept);
    if (narrow.PlaneError >= 0.0f)
    {
      masks = this->Kernels.UpdateNarrow(narrow, number, beams, *search.Packet, search.Hits);
    }
  }
  else
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    masks = this->Kernels.UpdateFromCorners(
      { { corners[0], corners[1], corners[2] }, this->Origin.Position, this->Unit }, number, beams,
      *search.Packet, search.Hits);
  }
  search.HaveRange &= ~masks.Changed;
  return masks.Uncertain == 0 ? masks.Changed
                              : masks.Changed | this->TestWide(triangle, masks.Uncertain, search);
}

// For beams in doubt: single precision only rejects, double precision and exact arithmetic
// decide.
std::uint32_t lms3dExactView::TestWide(
  std::uint32_t triangle, std::uint32_t beams, lms3dPacketSearch& search) const
{
  lms3dBeamPacket& packet = *search.Packet;
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  const lms3dSensorFrameTriangle inSensorFrame = lms3dToSensorFrame(corners, this->Origin.Position);
  const lms3dHitMasks masks = this->Kernels.Classify(inSensorFrame, beams, packet);
  const std::uint32_t met = masks.Hit | masks.Uncertain;
  if (met == 0)
  {
    return 0;
  }
  this->FindRanges(met & ~search.HaveRange, packet);
  search.HaveRange |= met;
  const std::uint32_t changed =
    this->Update(corners, inSensorFrame, static_cast<std::int32_t>(triangle), masks, packet);
  this->Kernels.NarrowRanges(packet, changed, this->Unit, search.Hits);
  return changed;
}

// Needs the packet's Range of the beams in the masks.
std::uint32_t lms3dExactView::Update(const lms3dCorners& corners,
  const lms3dSensorFrameTriangle& inSensorFrame, std::int32_t triangle, const lms3dHitMasks& masks,
  lms3dBeamPacket& packet) const
{
  std::uint32_t uncertain = masks.Uncertain;
  std::uint32_t changed = this->Kernels.UpdateNearest(
    inSensorFrame, triangle, masks.Hit, this->Origin.MaximumRange, packet, uncertain);
  if (uncertain != 0)
  {
    changed |= this->UpdateUncertain(corners, triangle, uncertain, masks.Uncertain, packet);
  }
  return changed;
}

// Updates `beams` with more digits than double precision gives. The beams in `needInsideTest` also
// need the exact test.
std::uint32_t lms3dExactView::UpdateUncertain(const lms3dCorners& corners, std::int32_t triangle,
  std::uint32_t beams, std::uint32_t needInsideTest, lms3dBeamPacket& packet) const
{
  double ranges[lms3dBeamPacket::Size];
  const lms3dDoubleDoublePlane plane =
    this->Kernels.MakeDoubleDoublePlane(corners.data(), this->Origin.Position);
  if (lms3dIsNearPlane(corners, this->Origin.Position, plane))
  {
    lms3dIntersectNearPlane(corners, this->Origin.Position, packet, ranges);
  }
  else
  {
    this->Kernels.IntersectDoubleDoublePlane(plane, packet, ranges);
  }
  std::uint32_t changed = 0;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const double range = ranges[beam];
    if (lms3dHasBit(beams, beam) && range > 0.0 && range <= this->Origin.MaximumRange &&
      lms3dIsNearerHit(range, triangle, packet, beam) &&
      (!lms3dHasBit(needInsideTest, beam) || IsInside(corners, this->Origin, beam, packet)))
    {
      packet.Range[beam] = range;
      packet.Triangle[beam] = triangle;
      changed |= 1u << beam;
    }
  }
  return changed;
}

void lms3dExactView::ComputeRanges(lms3dBeamPacket& packet) const
{
  this->FindRanges(packet.Active, packet);
}

void lms3dExactView::FindRanges(std::uint32_t beams, lms3dBeamPacket& packet) const
{
  while (beams != 0)
  {
    const std::int32_t triangle = packet.Triangle[lms3dGetFirstBit(beams)];
    const std::uint32_t same = lms3dFindBeams(triangle, beams, packet);
    this->FindRanges(triangle, same, packet);
    beams &= ~same;
  }
}

// A beam's range is what its triangle gives in a packet without other hits.
void lms3dExactView::FindRanges(
  std::int32_t triangle, std::uint32_t beams, lms3dBeamPacket& packet) const
{
  lms3dBeamPacket alone = packet;
  lms3dSetTriangle(lms3dBeamPacket::NoTriangle, alone);
  if (triangle != lms3dBeamPacket::NoTriangle)
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    const lms3dSensorFrameTriangle inSensorFrame =
      lms3dToSensorFrame(corners, this->Origin.Position);
    this->Update(
      corners, inSensorFrame, triangle, this->Kernels.Classify(inSensorFrame, beams, alone), alone);
  }
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    packet.Range[beam] = lms3dHasBit(beams, beam) ? alone.Range[beam] : packet.Range[beam];
  }
}
