// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dBeams.h"

lms3dBeams::lms3dBeams(const lms3dScanGeometry& geometry, const lms3dPose& pose)
  : Directions(geometry, pose)
  , Fan(geometry)
  , Position(pose.Position)
  , IsCentredAndStepped(geometry.GetPlatform().IsCentredAndStepped())
{
}

lms3dVector lms3dBeams::ToWorld(int turn, const lms3dVector& inTurnFrame) const
{
  const lms3dVector& fan = this->Directions.GetFanAxis(turn);
  const lms3dVector& axis = this->Directions.GetUp();
  const lms3dVector side = lms3dCross(axis, fan);
  return lms3dAdd(lms3dScale(fan, inTurnFrame[0]),
    lms3dAdd(lms3dScale(side, inTurnFrame[1]), lms3dScale(axis, inTurnFrame[2])));
}

lms3dVector lms3dBeams::GetOrigin(int turn, int beam) const
{
  return this->IsCentredAndStepped
    ? this->Position
    : lms3dAdd(this->Position, this->ToWorld(turn, this->Fan.Origins[beam]));
}

lms3dVector lms3dBeams::GetDirection(int turn, int beam) const
{
  return this->IsCentredAndStepped ? this->Directions.GetDirection(turn, beam)
                                   : this->ToWorld(turn, this->Fan.Directions[beam]);
}
