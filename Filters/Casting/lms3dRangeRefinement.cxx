// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dRangeRefinement.h"

#include "Casting/lms3dDoubleDoubleIntersector.h"
#include "Casting/lms3dHitRanges.h"
#include "Casting/lms3dPlaneCache.h"
#include "Casting/lms3dTriangle.h"
#include "Kernels/lms3dPacketKernels.h"

#include <tbb/enumerable_thread_specific.h>

namespace
{
// Enough for the packets of one call.
constexpr int EntriesOfCall = 64;

/// Intersects beams with planes in double precision. Planes that double precision cannot represent
/// well are computed with more digits and rounded.
class DoubleIntersector
{
public:
  DoubleIntersector(const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin)
    : Mesh(mesh)
    , Origin(origin.Position)
  {
  }

  void Intersect(std::int32_t triangle, const lms3dBeamPacket& packet, double* ranges)
  {
    this->Kernels.IntersectDoublePlane(
      this->Planes.Get(triangle, [this](std::int32_t t) { return MakePlane(t); }), packet, ranges);
  }

private:
  lms3dDoublePlane MakePlane(std::int32_t triangle) const
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    lms3dDoublePlane plane =
      this->Kernels.MakeDoublePlane(lms3dToSensorFrame(corners, this->Origin));
    if (!plane.IsWellConditioned)
    {
      const lms3dDoubleDoublePlane precise =
        this->Kernels.MakeDoubleDoublePlane(corners.data(), this->Origin);
      for (int axis = 0; axis < 3; ++axis)
      {
        plane.Normal[axis] = precise.Normal[axis].High;
      }
      plane.Offset = precise.Offset.High;
    }
    return plane;
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const double* Origin;
  lms3dPlaneCache<lms3dDoublePlane, EntriesOfCall> Planes;
};
} // namespace

void lms3dRefineRangesInDouble(
  const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count)
{
  DoubleIntersector intersector(mesh, origin);
  lms3dStoreHitRanges(intersector, origin.MaximumRange, packets, count);
}

struct lms3dRangeRefinement::Internals
{
  tbb::enumerable_thread_specific<lms3dDoubleDoubleIntersector> Intersectors;
};

lms3dRangeRefinement::lms3dRangeRefinement(const lms3dTriangleMesh& mesh)
  : Internal(new Internals{ tbb::enumerable_thread_specific<lms3dDoubleDoubleIntersector>(
      [&mesh] { return lms3dDoubleDoubleIntersector(mesh); }) })
{
}

lms3dRangeRefinement::~lms3dRangeRefinement() = default;

void lms3dRangeRefinement::Refine(
  const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const
{
  lms3dDoubleDoubleIntersector& intersector = this->Internal->Intersectors.local();
  intersector.SetOrigin(origin.Position);
  for (int i = 0; i < count; ++i)
  {
    intersector.Refine(origin.MaximumRange, packets[i]);
  }
}

bool lms3dRangeRefinement::FillTile(const lms3dRayOrigin& origin, std::int32_t triangle,
  const lms3dBeamsOfTile& beams, const lms3dRangeWindow& within, double* ranges,
  std::ptrdiff_t stride) const
{
  lms3dDoubleDoubleIntersector& intersector = this->Internal->Intersectors.local();
  intersector.SetOrigin(origin.Position);
  return intersector.FillTile(triangle, beams, within, ranges, stride);
}
