// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCornerPlaces.h"

#include <algorithm>
#include <cmath>

namespace
{
// Where a new corner may lie between two, as a share of their distance, in the order in which the
// places are tried.
constexpr std::array<double, 5> Shares = { 0.5, 0.25, 0.75, 0.0, 1.0 };
// Steps: how far a corner moves at most if the outline turns sharply, and the cosine of half the
// angle of the sharpest turn at which it moves.
constexpr double LargestWay = 2.0;
constexpr double SmallestCosine = 0.1;
// The sine of the smallest angle between edges that meet.
constexpr double SmallestSine = 1e-6;

// The unit vector to the right of the way from a to b.
lms3dPoint2 GetRight(const lms3dPoint2& a, const lms3dPoint2& b)
{
  const double u = b[0] - a[0];
  const double v = b[1] - a[1];
  const double length = std::hypot(u, v);
  return { v / length, -u / length };
}
} // namespace

std::vector<lms3dPoint2> lms3dFindMergedPlaces(const std::array<lms3dPoint2, 4>& points)
{
  const auto& [a, b, c, d] = points;
  std::vector<lms3dPoint2> places;
  const lms3dPoint2 ahead = { b[0] - a[0], b[1] - a[1] };
  const lms3dPoint2 back = { c[0] - d[0], c[1] - d[1] };
  const lms3dPoint2 across = { d[0] - a[0], d[1] - a[1] };
  const double cross = ahead[0] * back[1] - ahead[1] * back[0];
  const double along = (across[0] * back[1] - across[1] * back[0]) / cross;
  const double alongBack = (across[0] * ahead[1] - across[1] * ahead[0]) / cross;
  const double smallest =
    SmallestSine * std::hypot(ahead[0], ahead[1]) * std::hypot(back[0], back[1]);
  if (std::abs(cross) > smallest && along > 0.0 && alongBack > 0.0)
  {
    places.push_back({ a[0] + along * ahead[0], a[1] + along * ahead[1] });
  }
  for (const double share : Shares)
  {
    places.push_back({ b[0] + share * (c[0] - b[0]), b[1] + share * (c[1] - b[1]) });
  }
  return places;
}

std::optional<lms3dPoint2> lms3dFindWayOutwards(const std::array<lms3dPoint2, 3>& corners)
{
  const lms3dPoint2 first = GetRight(corners[0], corners[1]);
  const lms3dPoint2 second = GetRight(corners[1], corners[2]);
  const lms3dPoint2 sum = { first[0] + second[0], first[1] + second[1] };
  const double cosine = std::hypot(sum[0], sum[1]) / 2.0;
  // Two corners at one place have no cosine.
  if (!(cosine >= SmallestCosine))
  {
    return {};
  }
  const double scale = std::min(LargestWay, 1.0 / cosine) / (2.0 * cosine);
  return lms3dPoint2{ scale * sum[0], scale * sum[1] };
}
