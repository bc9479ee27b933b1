// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRangeJoins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace
{
/// Finds how planes lean, for lms3dDepthStep.
class LeanFinder
{
public:
  LeanFinder(const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep)
    : FanStep(fanStep)
  {
    double sine, cosine;
    lms3dSinCosDegrees(geometry.GetBetaStep(), sine, cosine);
    for (int beam = 0; beam < geometry.GetNumberOfBeams(); ++beam)
    {
      this->Factors.push_back(GetFactors(geometry, beam, 2.0 * (1.0 - cosine)));
    }
  }

  /// Of the plane through a return of a turn, that beside it, and that of the turn before or after.
  /// 0, as for an upright plane, where there is none beside it on its surface.
  double Find(const double* ranges, int beam) const
  {
    const auto& [neighbor, ofRange, ofNeighbor] = this->Factors[beam];
    const double* first = ranges + std::min(beam, neighbor);
    return neighbor != NoNeighbor && this->FanStep.IsJoined(first[-1], first[0], first[1], first[2])
      ? ofRange / ranges[beam] + ofNeighbor / ranges[neighbor]
      : 0.0;
  }

private:
  static constexpr int NoNeighbor = -1;

  struct Weights
  {
    int Neighbor;
    double OfRange;
    double OfNeighbor;
  };

  // The neighbour towards the horizon: where that is on another wall of a convex room, the plane
  // through it goes on behind the true one, so the room stays closed. With the angle s to it,
  // h = sin(e) w + cos(e) (w' - cos(s) w) / sin(s).
  static Weights GetFactors(const lms3dScanGeometry& geometry, int beam, double scale)
  {
    const double sine = geometry.GetAlphaSine(beam);
    const double cosine = geometry.GetAlphaCosine(beam);
    const int neighbor = beam + (sine * geometry.GetAlphaStep() > 0.0 ? -1 : 1);
    if (neighbor < 0 || neighbor >= geometry.GetNumberOfBeams())
    {
      return { NoNeighbor, 0.0, 0.0 };
    }
    const double otherSine = geometry.GetAlphaSine(neighbor);
    const double otherCosine = geometry.GetAlphaCosine(neighbor);
    const double sineOfStep = otherSine * cosine - otherCosine * sine;
    const double cosineOfStep = otherCosine * cosine + otherSine * sine;
    return { neighbor, scale * sine * (sine - cosine * cosineOfStep / sineOfStep),
      scale * sine * cosine / sineOfStep };
  }

  const lms3dDepthStep& FanStep;
  std::vector<Weights> Factors;
};

// Beyond a pole a fan goes on in the opposite turn: of an odd number of turns the two beside it, the
// nearer of which has the plane go farther.
double GetRangeBeyondPole(const lms3dRangeGrid& grid, int turn, int beam)
{
  const int turns = grid.GetNumberOfTurns();
  return grid.IsClosed() ? std::min(grid.GetRange((turn + turns / 2) % turns, beam),
                             grid.GetRange((turn + (turns + 1) / 2) % turns, beam))
                         : 0.0;
}

void JoinAlongFan(
  const lms3dRangeGrid& grid, int turn, const lms3dDepthStep& step, std::uint8_t* flags)
{
  const double* ranges = grid.GetRanges(turn);
  const int last = grid.GetNumberOfBeams() - 1;
  for (int i = 0; i < last; ++i)
  {
    flags[i] = step.IsJoined(ranges[i - 1], ranges[i], ranges[i + 1], ranges[i + 2])
      ? lms3dRangeJoins::AlongFan
      : 0;
  }
  flags[last] = 0;
  for (int pole : grid.GetPoles())
  {
    const bool isFirst = pole == 0;
    const int first = isFirst ? 0 : last - 1;
    if (last > 0 && (isFirst || pole == last))
    {
      const double beyond = GetRangeBeyondPole(grid, turn, isFirst ? 1 : first);
      const double* four = ranges + first - 1;
      flags[first] =
        step.IsJoined(isFirst ? beyond : four[0], four[1], four[2], isFirst ? four[3] : beyond)
        ? lms3dRangeJoins::AlongFan
        : 0;
    }
  }
}

void JoinAlongTurn(const lms3dRangeGrid& grid, int turn, const lms3dDepthStep& step,
  const LeanFinder& leans, std::uint8_t* flags)
{
  const double* before = grid.GetRanges(turn - 1);
  const double* here = grid.GetRanges(turn);
  const double* next = grid.GetRanges(turn + 1);
  const double* after = grid.GetRanges(turn + 2);
  for (int i = 0; i < grid.GetNumberOfBeams(); ++i)
  {
    // Most neighbours are equal.
    const bool isJoined = step.AreEqual(here[i], next[i]) ||
      (here[i] > 0.0 && next[i] > 0.0 &&
        step.AreOneSurface(
          before[i], here[i], next[i], after[i], leans.Find(here, i), leans.Find(next, i)));
    flags[i] |= isJoined ? lms3dRangeJoins::AlongTurn : 0;
  }
  for (int pole : grid.GetPoles())
  {
    flags[pole] &= lms3dRangeJoins::AlongFan;
  }
}
} // namespace

void lms3dRangeJoins::Find(const lms3dRangeGrid& grid, double depthStep)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  const lms3dDepthStep fanStep(depthStep, geometry.GetAlphaStep());
  const lms3dDepthStep turnStep(depthStep, geometry.GetBetaStep());
  const LeanFinder leans(geometry, fanStep);
  this->Flags.SetShape(grid.GetNumberOfTurns(), grid.GetNumberOfBeams());
  tbb::parallel_for(0, grid.GetNumberOfTurns(),
    [&](int turn)
    {
      std::uint8_t* flags = this->Flags.GetRow(turn);
      if (grid.HasReturns(turn))
      {
        JoinAlongFan(grid, turn, fanStep, flags);
        JoinAlongTurn(grid, turn, turnStep, leans, flags);
      }
      else
      {
        std::fill_n(flags, grid.GetNumberOfBeams(), 0);
      }
    });
  this->Flags.FillGhosts(grid.IsClosed());
}
