// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dBeamCasting.h"

#include "Scan/lms3dWideBeams.h"

namespace
{
bool CastThin(const lms3dBeamCastRequest& request, lms3dScanOutput& output)
{
  if (request.Beams)
  {
    return output.CastRays(request.Caster, *request.Beams, request.Limits,
      request.Processes.IsParallel(), request.Progress);
  }
  return request.Processes.IsParallel() ? output.CastPart(request.Caster, request.Geometry,
                                            request.Pose, request.Limits, request.Progress)
                                        : output.Cast(*request.Caster, request.Geometry,
                                            request.Pose, request.Limits, request.Progress);
}

// Runs `work`, which returns whether it is done, with the threads of the request, in all processes.
template <typename Work>
bool RunInAll(const lms3dBeamCastRequest& request, const Work& work)
{
  bool isDone = false;
  request.Processes.RunCollectively(
    [&] { request.Threads.Run(request.NumberOfThreads, [&] { isDone = work(); }); });
  return !request.Processes.AnyOf(!isDone);
}

bool CastWide(const lms3dBeamCastRequest& request, lms3dScanOutput& output)
{
  const lms3dProcesses& processes = request.Processes;
  const bool isParallel = processes.IsParallel();
  lms3dWideBeams wide(*request.Beams, request.Footprint, request.Limits);
  lms3dMixedBeams mixed = {};
  processes.RunCollectively(
    [&] { mixed = output.AllocateMixed(request.Geometry.CountBeamsOfAllTurns(), isParallel); });
  const double blocks = wide.GetNumberOfBlocks();
  for (int block = 0; block < wide.GetNumberOfBlocks(); ++block)
  {
    const lms3dProgress progress =
      lms3dGetStepProgress(request.Progress, block / blocks, (block + 1) / blocks);
    if (!RunInAll(request, [&] { return wide.Cast(block, request.Caster, isParallel, progress); }))
    {
      return false;
    }
    if (isParallel)
    {
      wide.ReduceToNearest(processes, request.Caster, request.FirstCell);
    }
    RunInAll(request,
      [&]
      {
        wide.Mix(block, mixed);
        return true;
      });
  }
  return true;
}
} // namespace

bool lms3dCastBeams(const lms3dBeamCastRequest& request, lms3dScanOutput& output)
{
  if (request.Beams && request.Footprint.HasWidth())
  {
    return CastWide(request, output);
  }
  if (!RunInAll(request, [&] { return CastThin(request, output); }))
  {
    return false;
  }
  if (request.Processes.IsParallel())
  {
    output.ReduceToNearest(request.Processes, request.Caster, request.FirstCell);
  }
  return true;
}
