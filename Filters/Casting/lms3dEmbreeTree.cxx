// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeTree.h"

#include "Casting/lms3dBuildStopped.h"
#include "Casting/lms3dEmbreeConfiguration.h"
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

lms3dEmbreeTree::lms3dEmbreeTree(
  const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded)
  : Normalization(mesh, excluded)
  , Device(rtcNewDevice(lms3dGetEmbreeConfiguration()))
{
  this->ThrowOnError();
  this->Scene.reset(rtcNewScene(this->Device.get()));
}

lms3dEmbreeHandle<RTCGeometry> lms3dEmbreeTree::NewGeometry(RTCGeometryType type) const
{
  return lms3dEmbreeHandle<RTCGeometry>(rtcNewGeometry(this->Device.get(), type));
}

void lms3dEmbreeTree::ThrowOnError() const
{
  lms3dThrowOnError(this->Device.get());
}

void lms3dEmbreeTree::Build(
  RTCGeometry geometry, RTCBuildQuality quality, const lms3dProgress& progress)
{
  RTCScene scene = this->Scene.get();
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, quality);
  this->ThrowOnError();
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
  this->ThrowOnError();
}
