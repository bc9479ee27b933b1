// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dPassedPlanes.h"

#include "Fusion/lms3dPassedBeams.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cstddef>

void lms3dMarkPassed(const lms3dSeenRanges& ranges, bool forgets, lms3dFusedPlanes& planes)
{
  const double bound = planes.GetMaximumError();
  tbb::enumerable_thread_specific<lms3dPassedBeams> beams(bound, forgets);
  tbb::parallel_for(std::size_t{ 0 }, planes.GetSize(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = planes[i];
      if (plane.GetBoxOfBlocks().IsNear(ranges.GetBox(), bound))
      {
        beams.local().Mark(ranges, plane, plane.GetGroups());
      }
    });
}

void lms3dMarkPassedEarlier(
  const std::vector<std::unique_ptr<lms3dSeenRanges>>& earlier, lms3dFusedPlanes& planes)
{
  const double bound = planes.GetMaximumError();
  tbb::enumerable_thread_specific<lms3dPassedBeams> beams(bound, false);
  tbb::parallel_for(std::size_t{ 0 }, planes.GetSize(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = planes[i];
      if (plane.OldBlocks == plane.Raster.GetNumberOfBlocks())
      {
        return;
      }
      const lms3dWorldBox box = plane.GetBoxOfBlocks(plane.OldBlocks);
      const lms3dBlockGroups groups(plane.Raster, plane.OldBlocks);
      for (const std::unique_ptr<lms3dSeenRanges>& ranges : earlier)
      {
        if (box.IsNear(ranges->GetBox(), bound))
        {
          beams.local().Mark(*ranges, plane, groups);
        }
      }
    });
}
