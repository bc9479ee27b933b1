// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dSurfaceQuery.h"

#include "Casting/lms3dEmbreePointQuery.h"
#include "Casting/lms3dFreeRangeRefinement.h"
#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dTriangleDistance.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dProgressReporter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>

namespace
{
// The points of a task: many enough to hide its cost, few enough for a quick abort.
constexpr std::size_t BlockSize = 1024;

constexpr double Unlimited = std::numeric_limits<double>::infinity();

// Runs `work` in parallel for each block of `count` points, given as its first and its end.
template <typename Work>
void RunInBlocks(std::size_t count, const lms3dProgress& progress, const Work& work)
{
  const std::size_t blocks = (count + BlockSize - 1) / BlockSize;
  lms3dProgressReporter reporter(progress);
  std::atomic<std::size_t> done{ 0 };
  tbb::parallel_for(std::size_t(0), blocks,
    [&](std::size_t block)
    {
      if (!reporter.IsStopped())
      {
        work(block * BlockSize, std::min(count, (block + 1) * BlockSize));
        reporter.Report(static_cast<double>(++done) / static_cast<double>(blocks));
      }
    });
  if (reporter.IsStopped())
  {
    throw lms3dBuildStopped();
  }
}

// Keeps the nearest of the triangles that Embree offers.
class NearestTriangle final : public lms3dNearestTest
{
public:
  NearestTriangle(const lms3dTriangleMesh& mesh, const lms3dVector& point)
    : Mesh(mesh)
    , Point(point)
  {
  }

  double Test(std::uint32_t triangle) override
  {
    const double distance =
      lms3dGetDistance(this->Point.data(), lms3dGetCorners(this->Mesh, triangle));
    const bool isNearer = distance < this->Nearest.Distance ||
      (distance == this->Nearest.Distance && triangle < this->Nearest.Triangle);
    if (isNearer)
    {
      this->Nearest = { distance, triangle };
    }
    return this->Nearest.Distance;
  }

  const lms3dNearest& Get() const { return this->Nearest; }

private:
  const lms3dTriangleMesh& Mesh;
  const lms3dVector& Point;
  lms3dNearest Nearest;
};

// Fills a packet with beams towards the points. `getOrigin` gives where a beam starts. A beam is
// inactive if its point is at its origin or not finite.
template <typename GetOrigin>
void AimAtPoints(
  const lms3dVector* points, int count, const GetOrigin& getOrigin, lms3dBeamPacket& packet)
{
  lms3dElevations elevations;
  lms3dFanAxes axes;
  std::fill_n(elevations.Cosine, lms3dBeamPacket::Size, 1.0);
  std::fill_n(elevations.Sine, lms3dBeamPacket::Size, 0.0);
  std::fill_n(axes.Up, 3, 0.0);
  packet.Active = 0;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const int point = std::min(i, count - 1);
    const lms3dVector beam = lms3dSubtract(points[point], getOrigin(point));
    const double length = std::hypot(beam[0], beam[1], beam[2]);
    const bool isBeam = length > 0.0 && std::isfinite(length);
    for (int axis = 0; axis < 3; ++axis)
    {
      axes.Horizontal[axis][i] = isBeam ? beam[axis] / length : axis == 0;
    }
    packet.Active |= isBeam && i < count ? 1u << i : 0u;
  }
  lms3dGetPacketKernels().GenerateDirections(elevations, axes, packet);
}

void SetOrigins(const lms3dVector* origins, int count, lms3dFreePacket& packet)
{
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const lms3dVector& origin = origins[std::min(i, count - 1)];
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][i] = origin[axis];
    }
  }
}

// Visits the packets of `count` points in parallel, each given as its first point and their number.
template <typename Visitor>
void ForEachPacket(std::size_t count, const lms3dProgress& progress, const Visitor& visit)
{
  constexpr std::size_t Size = lms3dBeamPacket::Size;
  static_assert(BlockSize % Size == 0, "A packet lies in one block.");
  RunInBlocks(count, progress,
    [&](std::size_t first, std::size_t last)
    {
      for (; first < last; first += Size)
      {
        visit(first, static_cast<int>(std::min(Size, last - first)));
      }
    });
}
} // namespace

lms3dSurfaceQuery::lms3dSurfaceQuery(lms3dTriangleMesh mesh, const lms3dProgress& progress)
  : Mesh(std::move(mesh))
  , Triangles(this->Mesh, this->Mesh.Triangles, progress)
  , Refinement(this->Mesh)
{
}

std::vector<lms3dNearest> lms3dSurfaceQuery::FindNearest(
  const Points& points, const lms3dProgress& progress) const
{
  std::vector<lms3dNearest> nearest(points.size());
  RunInBlocks(points.size(), progress,
    [&](std::size_t first, std::size_t last)
    {
      std::uint32_t guess = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        nearest[i] = this->FindNearest(points[i], guess);
        guess = nearest[i].Triangle;
      }
    });
  return nearest;
}

// The distance to `guess` bounds the search, so a triangle near a neighbouring point is a good
// guess.
lms3dNearest lms3dSurfaceQuery::FindNearest(const lms3dVector& point, std::uint32_t guess) const
{
  NearestTriangle test(this->Mesh, point);
  if (lms3dIsFinite(point))
  {
    lms3dFindNearestTriangle(this->Triangles, point.data(), test.Test(guess), test);
  }
  return test.Get();
}

std::vector<double> lms3dSurfaceQuery::GetRangesTowards(
  const lms3dVector& origin, const Points& points, const lms3dProgress& progress) const
{
  const lms3dRayOrigin rayOrigin = { { origin[0], origin[1], origin[2] }, Unlimited };
  std::vector<double> ranges(points.size());
  ForEachPacket(points.size(), progress,
    [&](std::size_t first, int count)
    {
      lms3dBeamPacket packet;
      AimAtPoints(
        &points[first], count, [&origin](int) { return origin; }, packet);
      this->Triangles.Cast(rayOrigin, &packet, 1);
      this->Refinement.Refine(rayOrigin, &packet, 1);
      std::copy_n(packet.Range, count, &ranges[first]);
    });
  return ranges;
}

std::vector<double> lms3dSurfaceQuery::GetRangesTowards(
  const Points& origins, const Points& points, const lms3dProgress& progress) const
{
  std::vector<double> ranges(points.size());
  ForEachPacket(points.size(), progress,
    [&](std::size_t first, int count)
    {
      lms3dFreePacket packet;
      SetOrigins(&origins[first], count, packet);
      AimAtPoints(
        &points[first], count, [&](int i) { return origins[first + i]; }, packet);
      this->Triangles.CastFree(Unlimited, &packet, 1);
      lms3dRefineFreeRanges(this->Mesh, &packet, 1);
      std::copy_n(packet.Range, count, &ranges[first]);
    });
  return ranges;
}
