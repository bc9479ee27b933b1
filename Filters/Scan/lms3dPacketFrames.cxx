// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dPacketFrames.h"

#include "Scan/lms3dPacketGrid.h"

#include <algorithm>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;
constexpr int Side = lms3dPacketGrid::Side;
} // namespace

void lms3dPacketFrames::Fill(
  const lms3dMovingBeams& beams, int firstTurn, int endTurn, int firstBeam)
{
  const int lastBeam = beams.GetGeometry().GetNumberOfBeams() - 1;
  for (int i = 0; i < Size; ++i)
  {
    const lms3dTurnFrame frame = beams.GetFrame(
      std::min(firstTurn + i / Side, endTurn - 1), std::min(firstBeam + i % Side, lastBeam));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Position[axis][i] = frame.Position[axis];
      this->Axes[0][axis][i] = frame.Fan[axis];
      this->Axes[1][axis][i] = frame.Side[axis];
      this->Axes[2][axis][i] = frame.Axis[axis];
    }
  }
}

void lms3dPacketFrames::ToWorld(
  const std::vector<lms3dVector>& ofFan, int firstBeam, double (&world)[3][Size]) const
{
  alignas(64) double local[3][Size];
  const int last = static_cast<int>(ofFan.size()) - 1;
  for (int i = 0; i < Size; ++i)
  {
    const lms3dVector& v = ofFan[std::min(firstBeam + i % Side, last)];
    local[0][i] = v[0];
    local[1][i] = v[1];
    local[2][i] = v[2];
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Size; ++i)
    {
      world[axis][i] = this->Axes[0][axis][i] * local[0][i] +
        (this->Axes[1][axis][i] * local[1][i] + this->Axes[2][axis][i] * local[2][i]);
    }
  }
}

void lms3dPacketFrames::SetDirections(
  const std::vector<lms3dVector>& directions, int firstBeam, lms3dBeamPacket& packet) const
{
  this->ToWorld(directions, firstBeam, packet.Direction);
}

void lms3dPacketFrames::SetOrigins(
  const std::vector<lms3dVector>& origins, int firstBeam, lms3dFreePacket& packet) const
{
  this->ToWorld(origins, firstBeam, packet.Origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Size; ++i)
    {
      packet.Origin[axis][i] = this->Position[axis][i] + packet.Origin[axis][i];
    }
  }
}
