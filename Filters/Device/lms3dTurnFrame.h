// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The frame of a turn (lms3dPlatform.h) in world coordinates.
 */
#ifndef lms3dTurnFrame_h
#define lms3dTurnFrame_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

struct lms3dTurnFrame
{
  /// The sensor's position, metres.
  lms3dVector Position;

  /// The unit vectors F, S and A.
  lms3dVector Fan;
  lms3dVector Side;
  lms3dVector Axis;

  /// Takes the components along F, S and A.
  lms3dVector ToWorld(const lms3dVector& inTurnFrame) const
  {
    return lms3dAdd(lms3dScale(this->Fan, inTurnFrame[0]),
      lms3dAdd(lms3dScale(this->Side, inTurnFrame[1]), lms3dScale(this->Axis, inTurnFrame[2])));
  }

  lms3dVector ToPoint(const lms3dVector& inTurnFrame) const
  {
    return lms3dAdd(this->Position, this->ToWorld(inTurnFrame));
  }
};

/// Returns the frame at the start of a turn of a sensor that stands at `pose`.
lms3dTurnFrame lms3dMakeTurnFrame(
  const lms3dScanGeometry& geometry, int turn, const lms3dPose& pose);

#endif
