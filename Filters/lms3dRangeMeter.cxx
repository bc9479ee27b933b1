// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRangeMeter.h"

#include "lms3dTriangle.h"

namespace
{
bool HasHits(const lms3dBeamPacket& packet)
{
  std::int32_t common = lms3dBeamPacket::NoTriangle;
  static_assert(lms3dBeamPacket::NoTriangle == -1, "all bits are set in NoTriangle alone");
  for (std::int32_t triangle : packet.Triangle)
  {
    common &= triangle;
  }
  return common != lms3dBeamPacket::NoTriangle;
}
} // namespace

lms3dRangeMeter::lms3dRangeMeter(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint)
  : Mesh(mesh)
  , Viewpoint(viewpoint)
  , Kernels(lms3dGetPacketKernels())
{
}

const lms3dRangeMeter::Entry& lms3dRangeMeter::GetEntry(std::int32_t triangle)
{
  Entry& entry = this->Entries[triangle % NumberOfEntries];
  if (entry.Triangle != triangle)
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    entry.Triangle = triangle;
    entry.Plane = this->Kernels.See(corners.data(), this->Viewpoint.Origin);
    entry.IsNear = lms3dIsNearPlane(corners, this->Viewpoint.Origin, entry.Plane);
  }
  return entry;
}

void lms3dRangeMeter::MeasureAll(
  std::int32_t triangle, const lms3dBeamPacket& packet, double* ranges)
{
  const Entry& entry = this->GetEntry(triangle);
  if (entry.IsNear)
  {
    lms3dMeasureNearPlane(
      lms3dGetCorners(this->Mesh, triangle), this->Viewpoint.Origin, packet, ranges);
  }
  else
  {
    this->Kernels.Measure(entry.Plane, packet, ranges);
  }
}

void lms3dRangeMeter::Measure(lms3dBeamPacket& packet)
{
  if (!HasHits(packet))
  {
    return;
  }
  bool isMeasured[lms3dBeamPacket::Size] = {};
  for (int first = 0; first < lms3dBeamPacket::Size; ++first)
  {
    const std::int32_t triangle = packet.Triangle[first];
    if (triangle == lms3dBeamPacket::NoTriangle || isMeasured[first])
    {
      continue;
    }
    double ranges[lms3dBeamPacket::Size];
    this->MeasureAll(triangle, packet, ranges);
    for (int beam = first; beam < lms3dBeamPacket::Size; ++beam)
    {
      if (packet.Triangle[beam] == triangle)
      {
        const bool isHit = ranges[beam] > 0.0 && ranges[beam] <= this->Viewpoint.MaximumRange;
        packet.Range[beam] = isHit ? ranges[beam] : lms3dBeamPacket::NoRange;
        packet.Triangle[beam] = isHit ? triangle : lms3dBeamPacket::NoTriangle;
        isMeasured[beam] = true;
      }
    }
  }
}

void lms3dMeasureRanges(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count)
{
  lms3dRangeMeter meter(mesh, viewpoint);
  for (int i = 0; i < count; ++i)
  {
    meter.Measure(packets[i]);
  }
}
