// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts all beams of a scan with all processes, for every device.
 */
#ifndef lms3dBeamCasting_h
#define lms3dBeamCasting_h

#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dProgress.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dDeviceSettings.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dScanOutput.h"

#include <cstdint>

class lms3dRayCaster;

/// References and pointers must outlive the cast.
struct lms3dBeamCastRequest
{
  /// Casts against this process's part of the scene. Null if the part has no triangles; not null if
  /// there is one process.
  const lms3dRayCaster* Caster;

  /// The number of the part's first cell.
  std::int64_t FirstCell;

  const lms3dScanGeometry& Geometry;
  const lms3dPose& Pose;

  /// Null if the sensor rests, its platform is centred and stepped, and beams have no width.
  const lms3dMovingBeams* Beams;

  const lms3dFootprint& Footprint;
  lms3dRangeLimits Limits;

  const lms3dProcesses& Processes;
  lms3dThreads& Threads;

  /// 0 stands for all cores.
  int NumberOfThreads;

  const lms3dProgress& Progress;
};

/// Fills the hits of `output`, with several processes by the whole scene. Returns false, in all
/// processes, if the work was stopped in one of them. Collective.
bool lms3dCastBeams(const lms3dBeamCastRequest& request, lms3dScanOutput& output);

#endif
