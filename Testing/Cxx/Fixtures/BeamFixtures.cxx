// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/BeamFixtures.h"

#include "Kernels/lms3dPacketKernels.h"

Beams MakeSame(const Vector& direction)
{
  Beams beams;
  beams.fill(direction);
  return beams;
}

lms3dBeamPacket MakePacket(const Beams& directions)
{
  lms3dElevations level;
  lms3dFanAxes axes;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    level.Cosine[i] = 1.0;
    level.Sine[i] = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      axes.Horizontal[axis][i] = directions[i][axis];
      axes.Up[axis] = 0.0;
    }
  }
  lms3dBeamPacket packet;
  lms3dGetPacketKernels().GenerateDirections(level, axes, packet);
  packet.Active = 0xffffu;
  return packet;
}
