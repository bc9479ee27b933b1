// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts the beams of one whole scan, band by band.
 */
#ifndef lms3dGridCaster_h
#define lms3dGridCaster_h

#include "Kernels/lms3dBeamPacket.h"

class lms3dGridCaster
{
public:
  virtual ~lms3dGridCaster() = default;

  /// A band is this number of turns, a multiple of lms3dBeamGrid::Side. The first begins at turn 0.
  virtual int GetTurnsOfBand() const = 0;

  /// Does what lms3dRayCaster::FindNearest does for all packets of a band, ordered by turn, then by
  /// beam. Several threads may call this at once.
  virtual void FindNearest(int firstTurn, lms3dBeamPacket* packets, int count) const = 0;
};

#endif
