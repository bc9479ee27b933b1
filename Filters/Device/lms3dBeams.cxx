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

lms3dTurnFrame lms3dBeams::GetFrame(int turn) const
{
  const lms3dVector& fan = this->Directions.GetFanAxis(turn);
  const lms3dVector& axis = this->Directions.GetUp();
  return { this->Position, fan, lms3dCross(axis, fan), axis };
}

lms3dVector lms3dBeams::GetOrigin(int turn, int beam) const
{
  return this->IsCentredAndStepped ? this->Position
                                   : this->GetFrame(turn).ToPoint(this->Fan.Origins[beam]);
}

lms3dVector lms3dBeams::GetDirection(int turn, int beam) const
{
  return this->IsCentredAndStepped ? this->Directions.GetDirection(turn, beam)
                                   : this->GetFrame(turn).ToWorld(this->Fan.Directions[beam]);
}
