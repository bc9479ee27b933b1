// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dRangeMeter.h"

#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>

namespace
{
/// What is known of the triangles that were met last: neighbouring packets meet the same.
template <typename Plane>
class PlaneCache
{
public:
  template <typename Make>
  const Plane& Get(std::int32_t triangle, const Make& make)
  {
    Entry& entry = this->Entries[triangle % NumberOfEntries];
    if (entry.Triangle != triangle)
    {
      entry.Triangle = triangle;
      entry.Value = make(triangle);
    }
    return entry.Value;
  }

private:
  struct Entry
  {
    std::int32_t Triangle = lms3dBeamPacket::NoTriangle;
    Plane Value;
  };

  static constexpr int NumberOfEntries = 64;

  std::array<Entry, NumberOfEntries> Entries;
};

/// To the last bits of a double.
class PreciseMeter
{
public:
  PreciseMeter(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint)
    : Mesh(mesh)
    , Origin(viewpoint.Origin)
  {
  }

  void Measure(std::int32_t triangle, const lms3dBeamPacket& packet, double* ranges)
  {
    const Plane& plane = this->Planes.Get(triangle, [this](std::int32_t t) { return See(t); });
    if (plane.IsNear)
    {
      lms3dMeasureNearPlane(lms3dGetCorners(this->Mesh, triangle), this->Origin, packet, ranges);
    }
    else
    {
      this->Kernels.Measure(plane.Seen, packet, ranges);
    }
  }

private:
  struct Plane
  {
    lms3dSeenPlane Seen;
    bool IsNear;
  };

  Plane See(std::int32_t triangle) const
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    const lms3dSeenPlane seen = this->Kernels.See(corners.data(), this->Origin);
    return { seen, lms3dIsNearPlane(corners, this->Origin, seen) };
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const double* Origin;
  PlaneCache<Plane> Planes;
};

/// In plain double.
class RoughMeter
{
public:
  RoughMeter(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint)
    : Mesh(mesh)
    , Origin(viewpoint.Origin)
  {
  }

  void Measure(std::int32_t triangle, const lms3dBeamPacket& packet, double* ranges)
  {
    this->Kernels.MeasureRoughly(
      this->Planes.Get(triangle, [this](std::int32_t t) { return See(t); }), packet, ranges);
  }

private:
  lms3dRoughPlane See(std::int32_t triangle) const
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    lms3dRoughPlane plane = this->Kernels.SeeRoughly(lms3dSee(corners, this->Origin));
    if (!plane.IsGood)
    {
      const lms3dSeenPlane seen = this->Kernels.See(corners.data(), this->Origin);
      for (int axis = 0; axis < 3; ++axis)
      {
        plane.Normal[axis] = seen.Normal[axis].High;
      }
      plane.Offset = seen.Offset.High;
    }
    return plane;
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const double* Origin;
  PlaneCache<lms3dRoughPlane> Planes;
};

int GetFirst(std::uint32_t beams)
{
  int first = 0;
  while (!((beams >> first) & 1u))
  {
    ++first;
  }
  return first;
}

template <typename Meter>
void MeasureHits(Meter& meter, double maximumRange, lms3dBeamPacket* packets, int count)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  for (int i = 0; i < count; ++i)
  {
    lms3dBeamPacket& packet = packets[i];
    std::uint32_t unmeasured = kernels.FindHits(packet);
    while (unmeasured != 0)
    {
      const std::int32_t triangle = packet.Triangle[GetFirst(unmeasured)];
      double ranges[lms3dBeamPacket::Size];
      meter.Measure(triangle, packet, ranges);
      unmeasured &= ~kernels.KeepRanges(ranges, triangle, maximumRange, packet);
    }
  }
}
} // namespace

void lms3dMeasureRanges(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count)
{
  PreciseMeter meter(mesh, viewpoint);
  MeasureHits(meter, viewpoint.MaximumRange, packets, count);
}

void lms3dMeasureRangesRoughly(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count)
{
  RoughMeter meter(mesh, viewpoint);
  MeasureHits(meter, viewpoint.MaximumRange, packets, count);
}
