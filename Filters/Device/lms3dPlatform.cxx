// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dPlatform.h"

std::array<lms3dVector, 3> lms3dGetPlatformAxes(
  lms3dMounting mounting, const std::array<lms3dVector, 3>& sensorAxes)
{
  const auto& [x, y, z] = sensorAxes;
  switch (mounting)
  {
    case lms3dMounting::Pitching:
      return { x, lms3dScale(z, -1.0), y };
    case lms3dMounting::Rolling:
      return { y, z, x };
    default:
      return sensorAxes;
  }
}

lms3dVector lms3dToPlatformAxes(lms3dMounting mounting, const lms3dVector& inSensorAxes)
{
  const auto& [x, y, z] = inSensorAxes;
  switch (mounting)
  {
    case lms3dMounting::Pitching:
      return { x, -z, y };
    case lms3dMounting::Rolling:
      return { y, z, x };
    default:
      return inSensorAxes;
  }
}
