// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dTurnFrame.h"

#include <array>

lms3dTurnFrame lms3dMakeTurnFrame(
  const lms3dScanGeometry& geometry, int turn, const lms3dPose& pose)
{
  const std::array<lms3dVector, 3> axes =
    lms3dGetPlatformAxes(geometry.GetPlatform().Mounting, pose.Axes);
  lms3dTurnFrame frame = { pose.Position, {}, {}, axes[2] };
  for (int axis = 0; axis < 3; ++axis)
  {
    // As lms3dBeamDirections does, to the bit.
    frame.Fan[axis] =
      geometry.GetBetaCosine(turn) * axes[0][axis] - geometry.GetBetaSine(turn) * axes[1][axis];
  }
  frame.Side = lms3dCross(frame.Axis, frame.Fan);
  return frame;
}
