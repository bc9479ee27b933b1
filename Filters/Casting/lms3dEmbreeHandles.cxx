// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeHandles.h"

#include <stdexcept>
#include <string>

namespace
{
// At exit, ParaView may delete filters after Embree's static objects, for example if a script calls
// sys.exit. Embree aborts if its objects are released then, so they are left to the system.
bool ProcessEnds = false;
const struct EndOfProcess
{
  ~EndOfProcess() { ProcessEnds = true; }
} NoticeEndOfProcess;

template <typename Handle>
void Release(void (*release)(Handle), Handle handle)
{
  if (!ProcessEnds)
  {
    release(handle);
  }
}
} // namespace

void lms3dEmbreeRelease::operator()(RTCDevice device) const
{
  Release(rtcReleaseDevice, device);
}

void lms3dEmbreeRelease::operator()(RTCGeometry geometry) const
{
  Release(rtcReleaseGeometry, geometry);
}

void lms3dEmbreeRelease::operator()(RTCScene scene) const
{
  Release(rtcReleaseScene, scene);
}

void lms3dThrowOnError(RTCDevice device)
{
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
  {
    throw std::runtime_error("Embree failed with its error " + std::to_string(error) +
      (error == RTC_ERROR_OUT_OF_MEMORY ? ": not enough memory for the scene. Simplify it." : "."));
  }
}
