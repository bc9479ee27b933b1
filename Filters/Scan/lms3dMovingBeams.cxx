// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dMovingBeams.h"

lms3dMovingBeams::lms3dMovingBeams(const lms3dScanGeometry& geometry, const lms3dPose& pose,
  const lms3dMotion* motion, double startTime)
  : Geometry(geometry)
  , Pose(pose)
  , Motion(motion)
  , StartTime(startTime)
  , FanPeriod(lms3dGetFanPeriod(geometry))
  , Resting(geometry, pose)
{
}

double lms3dMovingBeams::GetTime(int turn, int beam) const
{
  return this->StartTime + (turn * this->FanPeriod + this->GetFan().Times[beam]);
}

lms3dPose lms3dMovingBeams::GetPose(int turn, int beam) const
{
  return this->Motion ? this->Motion->GetPose(this->GetTime(turn, beam)) : this->Pose;
}

lms3dTurnFrame lms3dMovingBeams::GetFrame(int turn, int beam) const
{
  return this->Motion ? lms3dMakeTurnFrame(this->Geometry, turn, this->GetPose(turn, beam))
                      : this->Resting.GetFrame(turn);
}

lms3dVector lms3dMovingBeams::GetOrigin(int turn, int beam) const
{
  return this->Motion ? this->GetFrame(turn, beam).ToPoint(this->GetFan().Origins[beam])
                      : this->Resting.GetOrigin(turn, beam);
}

lms3dVector lms3dMovingBeams::GetDirection(int turn, int beam) const
{
  return this->Motion ? this->GetFrame(turn, beam).ToWorld(this->GetFan().Directions[beam])
                      : this->Resting.GetDirection(turn, beam);
}
