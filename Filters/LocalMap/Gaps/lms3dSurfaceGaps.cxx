// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dSurfaceGaps.h"

#include "Geometry/lms3dAngle.h"
#include "LocalMap/Patches/lms3dPatches.h"
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// A plane explains returns within this number of standard deviations of the noise.
constexpr double ExplainedDeviations = 4.0;
// The noise is estimated from each eighth turn.
constexpr int NoiseStride = 8;
// The smallest cosine of the angle between a beam and the normal of its plane, for the area.
constexpr double MinimumCosine = 1e-3;

using Groups = lms3dBeamGroups::Groups;

// As lms3dEstimateNoise(), from the beams of the grid.
double EstimateNoise(const lms3dBeamStates& states, int step)
{
  const int beams = states.GetNumberOfBeams();
  std::vector<lms3dVector> directions(beams);
  std::vector<double> residuals;
  for (int turn = 0; turn < states.GetNumberOfTurns(); turn += NoiseStride)
  {
    const double* const ranges = states.GetRanges(turn);
    for (int beam = 0; beam < beams; ++beam)
    {
      directions[beam] = states.GetRay(turn * beams + beam).Direction;
    }
    for (int beam = step; beam + step < beams; ++beam)
    {
      const double below = ranges[beam - step];
      const double range = ranges[beam];
      const double above = ranges[beam + step];
      if (below > 0.0 && range > 0.0 && above > 0.0)
      {
        const double cosine = 0.5 *
          lms3dDot(directions[beam], lms3dAdd(directions[beam - step], directions[beam + step]));
        residuals.push_back(
          std::abs(1.0 / below + 1.0 / above - 2.0 * cosine / range) * range * range);
      }
    }
  }
  return lms3dGetNoiseOfResiduals(residuals);
}

} // namespace

lms3dSurfaceGaps::lms3dSurfaceGaps(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
  const lms3dMapGeometry& geometry, const lms3dGapSettings& settings,
  const std::vector<bool>& isFree)
  : Settings(settings)
  , AlphaStep(std::abs(grid.GetGeometry().GetAlphaStep()) * lms3dRadiansPerDegree)
  , BetaStep(std::abs(grid.GetGeometry().GetBetaStep()) * lms3dRadiansPerDegree)
  , LargerStep(std::max(this->AlphaStep, this->BetaStep) / lms3dRadiansPerDegree)
{
  lms3dBeamStates states(grid, geometry, isFree);
  const double noise = EstimateNoise(states, geometry.GetInterlacedBeams());
  const double bound = grid.LimitToLargestRange(settings.MaximumError);
  const double tolerance = std::max(lms3dPatches::MergedShare * bound, ExplainedDeviations * noise);
  const lms3dSurroundings surroundings(states, tolerance, settings.DepthStep);
  if (settings.MaximumSpeckleSize > 0)
  {
    this->FindSpeckles(joins, states, surroundings);
  }
  if (settings.MaximumGapSize > 0)
  {
    this->FindGaps(states, surroundings);
  }
}

void lms3dSurfaceGaps::FindGaps(lms3dBeamStates& states, const lms3dSurroundings& surroundings)
{
  const Groups groups = lms3dBeamGroups(states).FindMissing(this->Settings.MaximumGapSize);
  const std::vector<Filling> fillings = this->Fill(states, surroundings, groups);
  int number = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (!fillings[i].Ranges.empty())
    {
      this->Append(states, groups[i], fillings[i], number++, this->GapBeams);
    }
  }
}

std::vector<lms3dSurfaceGaps::Filling> lms3dSurfaceGaps::Fill(const lms3dBeamStates& states,
  const lms3dSurroundings& surroundings, const lms3dBeamGroups::Groups& groups) const
{
  std::vector<Filling> fillings(groups.size());
  tbb::parallel_for(std::size_t(0), groups.size(),
    [&](std::size_t i) { fillings[i] = this->FillGroup(states, surroundings, groups[i]); });
  return fillings;
}

lms3dSurfaceGaps::Filling lms3dSurfaceGaps::FillGroup(const lms3dBeamStates& states,
  const lms3dSurroundings& surroundings, const std::vector<int>& group) const
{
  const std::optional<lms3dPlane> plane = surroundings.FitPlane(group);
  Filling filling;
  filling.Ranges.reserve(plane ? group.size() : 0);
  filling.Areas.reserve(plane ? group.size() : 0);
  for (std::size_t i = 0; plane && i < group.size(); ++i)
  {
    const double range = surroundings.GetRange(group[i], *plane);
    if (!(range > 0.0 && std::isfinite(range)) || states.IsBeyondAxis(group[i], range))
    {
      return {};
    }
    filling.Ranges.push_back(range);
    filling.Areas.push_back(this->GetArea(states, group[i], *plane, range));
  }
  return filling;
}

double lms3dSurfaceGaps::GetArea(
  const lms3dBeamStates& states, int place, const lms3dPlane& plane, double range) const
{
  const lms3dVector direction = states.GetRay(place).Direction;
  const double level = std::hypot(direction[0], direction[1]);
  const double cosine = std::abs(lms3dDot(plane.Q, direction)) / lms3dGetLength(plane.Q);
  return this->AlphaStep * this->BetaStep * level * range * range / std::max(cosine, MinimumCosine);
}

void lms3dSurfaceGaps::Append(const lms3dBeamStates& states, const std::vector<int>& group,
  const Filling& filling, int number, std::vector<lms3dGapBeam>& beams)
{
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    const int turn = states.GetTurn(group[i]);
    const int beam = states.GetBeam(group[i]);
    beams.push_back({ turn, beam, states.GetBeamId(group[i]), number, states.GetRange(group[i]),
      filling.Areas[i] });
    this->FilledBeams.push_back({ turn, beam, filling.Ranges[i] });
  }
}
