// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPoleRanges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
using Extremes = std::array<double, 2>;

// The nearest and the farthest of the returns that one vertex can represent.
Extremes FindRepresentable(
  const std::vector<double>& ranges, double median, const Extremes& all, double maximumError)
{
  if (all[1] - all[0] <= 2.0 * maximumError)
  {
    return all;
  }
  Extremes near = { median, median };
  for (double range : ranges)
  {
    if (std::abs(range - median) <= maximumError)
    {
      near = { std::min(near[0], range), std::max(near[1], range) };
    }
  }
  return near;
}
} // namespace

std::vector<lms3dVector> lms3dSetPoleRanges(
  const lms3dRangeGrid& grid, double maximumError, lms3dBeamSphere& sphere)
{
  std::vector<lms3dVector> extremes;
  for (std::size_t i = 0; i < grid.GetPoles().size(); ++i)
  {
    const std::vector<double>& ranges = grid.GetRangesOfPoles()[i];
    if (ranges.empty())
    {
      continue;
    }
    const int row = sphere.GetBeam(0) == grid.GetPoles()[i] ? 0 : sphere.GetNumberOfRows() - 1;
    const lms3dBeamSphere::GridIndex index = sphere.GetIndex(0, row);
    const auto [nearest, farthest] = std::minmax_element(ranges.begin(), ranges.end());
    const Extremes near =
      FindRepresentable(ranges, sphere.GetRange(index), { *nearest, *farthest }, maximumError);
    sphere.SetPole(row, near[0], near[1]);
    extremes.push_back(lms3dScale(sphere.GetDirection(index), *nearest));
    if (*nearest < *farthest)
    {
      extremes.push_back(lms3dScale(sphere.GetDirection(index), *farthest));
    }
  }
  return extremes;
}
