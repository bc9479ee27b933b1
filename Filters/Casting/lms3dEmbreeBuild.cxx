// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeBuild.h"

#include "Pipeline/lms3dProgressReporter.h"

#include <algorithm>

namespace
{
// Embree calls this on any of its threads. Its estimate can exceed 1.
bool Report(void* reporter, double done)
{
  return static_cast<lms3dProgressReporter*>(reporter)->Report(std::clamp(done, 0.0, 1.0));
}
} // namespace

void lms3dCommitScene(RTCDevice device, RTCScene scene, const lms3dProgress& progress)
{
  lms3dProgressReporter reporter(progress);
  if (progress)
  {
    rtcSetSceneProgressMonitorFunction(scene, &Report, &reporter);
  }
  rtcCommitScene(scene);
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  if (reporter.IsStopped())
  {
    throw lms3dBuildStopped();
  }
  lms3dThrowOnError(device);
}
