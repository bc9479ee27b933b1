// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the beams of a resting sensor start and point, in world coordinates, for any
 * platform.
 */
#ifndef lms3dBeams_h
#define lms3dBeams_h

#include "Device/lms3dFan.h"
#include "Device/lms3dScanGeometry.h"
#include "Device/lms3dTurnFrame.h"
#include "Geometry/lms3dVector.h"

/// For a platform that is centred and stepped, directions equal the ones of lms3dBeamDirections to
/// the bit.
class lms3dBeams
{
public:
  /// The geometry must outlive the object.
  lms3dBeams(const lms3dScanGeometry& geometry, const lms3dPose& pose);

  lms3dVector GetOrigin(int turn, int beam) const;

  lms3dVector GetDirection(int turn, int beam) const;

  /// Returns the frame at the start of a turn. GetFan has the beams in such a frame.
  lms3dTurnFrame GetFrame(int turn) const;

  const lms3dFan& GetFan() const { return this->Fan; }

private:
  const lms3dBeamDirections Directions;
  const lms3dFan Fan;
  const lms3dVector Position;
  const bool IsCentredAndStepped;
};

#endif
