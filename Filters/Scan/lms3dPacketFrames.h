// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The frames of the beams of a packet, and the way from them to world coordinates.
 */
#ifndef lms3dPacketFrames_h
#define lms3dPacketFrames_h

#include "Geometry/lms3dVector.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Scan/lms3dMovingBeams.h"

#include <vector>

/// A frame for each beam (lms3dTurnFrame), ordered for vector instructions.
class lms3dPacketFrames
{
public:
  /// Fills the frames of the packet at a turn and beam. Beyond the end of the fan, and of the turns
  /// up to `endTurn`, it repeats the last frame.
  void Fill(const lms3dMovingBeams& beams, int firstTurn, int endTurn, int firstBeam);

  ///@{
  /// Sets Direction, or Origin, of a packet. The vectors, one for each beam of the fan,
  /// are in the frame of the turn. The results equal the ones of lms3dTurnFrame to the bit.
  void SetDirections(
    const std::vector<lms3dVector>& directions, int firstBeam, lms3dBeamPacket& packet) const;
  void SetOrigins(
    const std::vector<lms3dVector>& origins, int firstBeam, lms3dFreePacket& packet) const;
  ///@}

private:
  void ToWorld(const std::vector<lms3dVector>& ofFan, int firstBeam,
    double (&world)[3][lms3dBeamPacket::Size]) const;

  alignas(64) double Position[3][lms3dBeamPacket::Size];

  /// F, S and A.
  alignas(64) double Axes[3][3][lms3dBeamPacket::Size];
};

#endif
