// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dGridCone.h"

#include <algorithm>
#include <array>

namespace
{
double Dot(const double (&x)[3], const std::array<double, 3>& y)
{
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
} // namespace

bool lms3dIsOutside(
  const lms3dCone& cone, const lms3dBeamGrid& grid, const lms3dPacketRectangle& rectangle)
{
  constexpr int Side = lms3dBeamGrid::Side;
  const int endTurn = std::min(rectangle.FirstTurn + rectangle.Rows * Side, grid.Turns);
  const int endBeam = std::min(rectangle.FirstBeam + rectangle.Columns * Side, grid.Beams);
  // Cosines of elevations are not negative, so each beam is nearest to the cone's axis in the turn
  // whose fan is.
  double fan = Dot(cone.Axis, grid.FanAxes[rectangle.FirstTurn]);
  for (int turn = rectangle.FirstTurn + 1; turn < endTurn; ++turn)
  {
    fan = std::max(fan, Dot(cone.Axis, grid.FanAxes[turn]));
  }
  const double up = Dot(cone.Axis, grid.Up);
  int inside = 0;
  for (int beam = rectangle.FirstBeam; beam < endBeam; ++beam)
  {
    inside |= grid.Cosines[beam] * fan + grid.Sines[beam] * up >= cone.Minimum ? 1 : 0;
  }
  return inside == 0;
}
