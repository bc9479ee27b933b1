// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dDoubleDoubleIntersector.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dTriangle.h"

#include <algorithm>

namespace
{
// Measured: where a packet has more triangles, it is faster to intersect each beam with its own
// plane.
constexpr int MaximumOneByOne = 2;

void SetPlane(const lms3dDoubleDoublePlane& plane, int beam, lms3dPacketPlanes& planes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    planes.High[axis][beam] = plane.Normal[axis].High;
    planes.Low[axis][beam] = plane.Normal[axis].Low;
  }
  planes.High[3][beam] = plane.Offset.High;
  planes.Low[3][beam] = plane.Offset.Low;
}

lms3dDoubleDoublePlane GetPlaneOf(const lms3dPacketPlanes& planes, int i)
{
  const auto get = [&planes, i](int number) {
    return lms3dDoubleDouble{ planes.High[number][i], planes.Low[number][i] };
  };
  return { { get(0), get(1), get(2) }, get(3) };
}
} // namespace

/// The triangles of a packet whose planes are not kept, and their planes.
struct lms3dDoubleDoubleIntersector::MissingPlanes
{
  // Returns where the plane of a triangle will be.
  const Plane* Add(std::int32_t triangle)
  {
    std::int32_t* const end = this->Triangles + this->Count;
    std::int32_t* const found = std::find(this->Triangles, end, triangle);
    if (found == end)
    {
      *found = triangle;
      ++this->Count;
    }
    return this->Planes + (found - this->Triangles);
  }

  std::int32_t Triangles[lms3dBeamPacket::Size];
  Plane Planes[lms3dBeamPacket::Size];
  int Count = 0;
};

void lms3dDoubleDoubleIntersector::SetOrigin(const double origin[3])
{
  if (!std::equal(this->Origin, this->Origin + 3, origin))
  {
    std::copy_n(origin, 3, this->Origin);
    this->Planes.Clear();
  }
}

void lms3dDoubleDoubleIntersector::Refine(double maximumRange, lms3dBeamPacket& packet)
{
  std::uint32_t remaining = this->Kernels.FindHits(packet);
  for (int i = 0; i < MaximumOneByOne && remaining != 0; ++i)
  {
    remaining &= ~this->RefineFirst(remaining, maximumRange, packet);
  }
  if (remaining == 0 || this->RefineEach(remaining, maximumRange, packet))
  {
    return;
  }
  while (remaining != 0)
  {
    remaining &= ~this->RefineFirst(remaining, maximumRange, packet);
  }
}

bool lms3dDoubleDoubleIntersector::FillTile(std::int32_t triangle, const lms3dBeamsOfTile& beams,
  const lms3dRangeWindow& within, double* ranges, std::ptrdiff_t stride)
{
  const Plane& plane = this->GetPlane(triangle);
  return !plane.IsNear && this->Kernels.IntersectTile(plane.Value, beams, within, ranges, stride);
}

// Refines the beams that have the same triangle as the first of `beams`, and returns them.
std::uint32_t lms3dDoubleDoubleIntersector::RefineFirst(
  std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet)
{
  const std::int32_t triangle = packet.Triangle[lms3dGetFirstBit(beams)];
  const Plane& plane = this->GetPlane(triangle);
  if (!plane.IsNear)
  {
    return this->Kernels.RefineRanges(plane.Value, triangle, maximumRange, packet);
  }
  alignas(64) double ranges[lms3dBeamPacket::Size];
  lms3dIntersectNearPlane(lms3dGetCorners(this->Mesh, triangle), this->Origin, packet, ranges);
  return this->Kernels.StoreRanges(ranges, triangle, maximumRange, packet);
}

// Refines `beams`, each with its own plane. Does nothing and returns false if a plane is near to
// the origin.
bool lms3dDoubleDoubleIntersector::RefineEach(
  std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet)
{
  MissingPlanes missing;
  const Plane* planes[lms3dBeamPacket::Size];
  for (std::uint32_t rest = beams; rest != 0; rest &= rest - 1)
  {
    const int beam = lms3dGetFirstBit(rest);
    const Plane* const kept = this->Planes.Find(packet.Triangle[beam]);
    planes[beam] = kept ? kept : missing.Add(packet.Triangle[beam]);
  }
  this->MakePlanes(missing);
  lms3dPacketPlanes values;
  const Plane* const any = planes[lms3dGetFirstBit(beams)];
  bool isNear = false;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const Plane& plane = lms3dHasBit(beams, beam) ? *planes[beam] : *any;
    SetPlane(plane.Value, beam, values);
    isNear |= plane.IsNear;
  }
  // Only now, since a plane can take the place of one that is used here.
  for (int i = 0; i < missing.Count; ++i)
  {
    this->Planes.Set(missing.Triangles[i], missing.Planes[i]);
  }
  if (!isNear)
  {
    alignas(64) double ranges[lms3dBeamPacket::Size];
    this->Kernels.IntersectDoubleDoublePlanes(values, packet, ranges);
    this->Kernels.StoreRangesOfBeams(ranges, beams, maximumRange, packet);
  }
  return !isNear;
}

void lms3dDoubleDoubleIntersector::MakePlanes(MissingPlanes& missing) const
{
  constexpr int Step = lms3dPacketPlanes::Step;
  const int end = (missing.Count + Step - 1) / Step * Step;
  lms3dPacketCorners corners;
  for (int i = 0; i < end; ++i)
  {
    const std::int32_t triangle = missing.Triangles[std::min(i, missing.Count - 1)];
    for (int corner = 0; corner < 3; ++corner)
    {
      const double* const point = this->Mesh.GetCorner(triangle, corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        corners.Corner[corner][axis][i] = point[axis];
      }
    }
  }
  lms3dPacketPlanes planes;
  this->Kernels.MakeDoubleDoublePlanes(corners, end, this->Origin, planes);
  for (int i = 0; i < missing.Count; ++i)
  {
    const lms3dCorners ofTriangle = lms3dGetCorners(this->Mesh, missing.Triangles[i]);
    const lms3dDoubleDoublePlane plane = GetPlaneOf(planes, i);
    missing.Planes[i] = { plane, lms3dIsNearPlane(ofTriangle, this->Origin, plane) };
  }
}

lms3dDoubleDoubleIntersector::Plane lms3dDoubleDoubleIntersector::MakePlane(
  std::int32_t triangle) const
{
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  const lms3dDoubleDoublePlane plane =
    this->Kernels.MakeDoubleDoublePlane(corners.data(), this->Origin);
  return { plane, lms3dIsNearPlane(corners, this->Origin, plane) };
}
