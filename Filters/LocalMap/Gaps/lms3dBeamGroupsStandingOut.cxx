// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dBeamGroups.h"

#include <algorithm>
#include <array>

namespace
{

// Whether a range lies on a side of the line through the ranges beside it, farther away from it
// than `height`, metres. The inverse ranges of a line
// are linear, apart from the cosine of the small angle between beams.
bool IsOffLine(double before, double range, double after, lms3dBeamGroups::Side side, double height)
{
  const double sum = before + after;
  return before > 0.0 && after > 0.0 && side * (2.0 * before * after - range * sum) > height * sum;
}
} // namespace

std::vector<int> lms3dBeamGroups::FindStandingOutOfTurn(
  int turn, Side side, double height, const lms3dDepthStep& step) const
{
  std::vector<int> found;
  const double* const ranges = this->States.GetRanges(turn);
  const int start = turn * this->States.GetNumberOfBeams();
  for (int beam = 1; beam + 1 < this->States.GetNumberOfBeams(); ++beam)
  {
    if (IsOffLine(ranges[beam - 1], ranges[beam], ranges[beam + 1], side, height) &&
      this->StandsOut(start + beam, side, height, step))
    {
      found.push_back(start + beam);
    }
  }
  return found;
}

// Whether a return lies on a side of the line in its turn, and at one depth with all beside it.
bool lms3dBeamGroups::StandsOut(
  int place, Side side, double height, const lms3dDepthStep& step) const
{
  if (this->States.GetState(place) != lms3dBeamStates::Returned || this->States.IsPole(place))
  {
    return false;
  }
  const double range = this->States.GetRange(place);
  const std::array<int, 8> neighbors = this->States.GetNeighbors(place);
  const bool isAtOneDepth = std::all_of(neighbors.begin(), neighbors.begin() + StraightNeighbors,
    [&](int neighbor)
    {
      return neighbor != lms3dBeamStates::NoPlace &&
        step.AreRangesEqual(range, this->States.GetRange(neighbor));
    });
  return isAtOneDepth &&
    IsOffLine(this->States.GetRange(neighbors[2]), range, this->States.GetRange(neighbors[3]), side,
      height);
}
