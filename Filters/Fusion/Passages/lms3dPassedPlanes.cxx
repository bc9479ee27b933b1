// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dPassedPlanes.h"

#include "Fusion/Passages/lms3dPassedBeams.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace
{
// Whether beams that pass can change the mesh of a plane. A facet goes with its return alone.
bool MayChange(const lms3dFusedPlane& plane, bool forgets)
{
  return plane.Raster.GetNumberOfBlocks() > 0 && (forgets || !plane.IsFacet());
}
} // namespace

void lms3dMarkPassed(const lms3dSeenRanges& ranges, bool forgets, lms3dFusedPlanes& planes)
{
  const double bound = planes.GetMaximumError();
  tbb::enumerable_thread_specific<lms3dPassedBeams> beams(bound, forgets);
  tbb::parallel_for(std::size_t{ 0 }, planes.GetSize(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = planes[i];
      if (MayChange(plane, forgets) && plane.GetBoxOfBlocks().IsNear(ranges.GetBox(), bound))
      {
        beams.local().Mark(ranges, plane, plane.GetGroups());
      }
    });
}

void lms3dMarkPassedEarlier(
  const std::vector<std::unique_ptr<lms3dSeenRanges>>& earlier, lms3dFusedPlanes& planes)
{
  const double bound = planes.GetMaximumError();
  std::vector<lms3dWorldBox> boxes;
  boxes.reserve(earlier.size());
  for (const std::unique_ptr<lms3dSeenRanges>& ranges : earlier)
  {
    boxes.push_back(ranges->GetBox());
  }
  tbb::enumerable_thread_specific<lms3dPassedBeams> beams(bound, false);
  tbb::parallel_for(std::size_t{ 0 }, planes.GetSize(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = planes[i];
      if (plane.OldBlocks == plane.Raster.GetNumberOfBlocks() || !MayChange(plane, false))
      {
        return;
      }
      const lms3dWorldBox box = plane.GetBoxOfBlocks(plane.OldBlocks);
      const lms3dBlockGroups groups(plane.Raster, plane.OldBlocks);
      for (std::size_t scan = 0; scan < boxes.size(); ++scan)
      {
        if (box.IsNear(boxes[scan], bound))
        {
          beams.local().Mark(*earlier[scan], plane, groups);
        }
      }
    });
}
