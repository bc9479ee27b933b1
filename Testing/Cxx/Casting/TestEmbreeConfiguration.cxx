// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeConfiguration.h"
#include "Casting/lms3dEmbreeHandles.h"

#include <gtest/gtest.h>

namespace
{
/// Returns how many rays of a packet a device casts by one instruction for all.
int GetRaysAtOnce(const char* configuration)
{
  const lms3dEmbreeHandle<RTCDevice> device(rtcNewDevice(configuration));
  lms3dThrowOnError(device.get());
  if (rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
  {
    return 16;
  }
  return rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}
} // namespace

TEST(EmbreeConfiguration, LeavesEmbreeItsChoiceWithTheWidestKernels)
{
  const int last = lms3dGetNumberOfPacketKernels() - 1;
  EXPECT_EQ(lms3dGetEmbreeConfiguration(lms3dGetPacketKernels(last)), nullptr);
}

TEST(EmbreeConfiguration, RestrictsEmbreeToNarrowerKernels)
{
  for (int i = 0; i + 1 < lms3dGetNumberOfPacketKernels(); ++i)
  {
    const lms3dPacketKernels& kernels = lms3dGetPacketKernels(i);
    EXPECT_EQ(GetRaysAtOnce(lms3dGetEmbreeConfiguration(kernels)), kernels.RaysAtOnce);
  }
}
