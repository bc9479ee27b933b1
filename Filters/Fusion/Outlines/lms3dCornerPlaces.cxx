// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dCornerPlaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Where a new corner may lie between two, as a share of their distance, in the order in which the
// places are tried.
constexpr std::array<double, 5> Shares = { 0.5, 0.25, 0.75, 0.0, 1.0 };
// Steps: how far a corner moves at most, and the cosine of half the angle of the sharpest turn at
// which both of its edges move, and the sine of the smallest turn at which one of them does.
constexpr double LargestWay = 2.0;
constexpr double SmallestCosine = 0.1;
constexpr double SmallestSineOfTurn = 0.1;
// The sine of half the angle of the sharpest corner that is made.
constexpr double SmallestSineOfCorner = 0.06;
// Less than the squared cosine of the turn at such a corner.
constexpr double SmallestSquaredCosine = 0.9;
// If more than two corners become one, lines go through each end and this number of the corners
// next to it.
constexpr std::size_t LinesOfEnd = 2;
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

// Whether the angle between two ways may be nearly two right angles.
bool MayTurnBack(const lms3dPoint2& a, const lms3dPoint2& b)
{
  const double dot = a[0] * b[0] + a[1] * b[1];
  const double squares = (a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]);
  return dot < 0.0 && dot * dot >= SmallestSquaredCosine * squares;
}

using Line = std::array<lms3dPoint2, 2>;

// Adds the point in which two lines meet ahead of their first points.
void AddMeetingPlace(const Line& first, const Line& second, std::vector<lms3dPoint2>& places)
{
  const lms3dPoint2 ahead = { first[1][0] - first[0][0], first[1][1] - first[0][1] };
  const lms3dPoint2 back = { second[1][0] - second[0][0], second[1][1] - second[0][1] };
  const lms3dPoint2 across = { second[0][0] - first[0][0], second[0][1] - first[0][1] };
  const double cross = ahead[0] * back[1] - ahead[1] * back[0];
  const double along = (across[0] * back[1] - across[1] * back[0]) / cross;
  const double alongBack = (across[0] * ahead[1] - across[1] * ahead[0]) / cross;
  const double smallest =
    SmallestSine * std::hypot(ahead[0], ahead[1]) * std::hypot(back[0], back[1]);
  if (std::abs(cross) > smallest && along > 0.0 && alongBack > 0.0)
  {
    places.push_back({ first[0][0] + along * ahead[0], first[0][1] + along * ahead[1] });
  }
}
} // namespace

std::vector<lms3dPoint2> lms3dFindMergedPlaces(const std::vector<lms3dPoint2>& points)
{
  const lms3dPoint2& first = points.front();
  const lms3dPoint2& last = points.back();
  const std::size_t count = points.size() - 2;
  std::vector<lms3dPoint2> places;
  const std::size_t lines = std::min(count - 1, LinesOfEnd);
  for (std::size_t i = 0; i < lines; ++i)
  {
    for (std::size_t j = 0; j < lines; ++j)
    {
      AddMeetingPlace({ first, points[1 + i] }, { last, points[count - j] }, places);
    }
  }
  if (count > 2)
  {
    places.insert(places.end(), points.begin() + 1, points.end() - 1);
    return places;
  }
  const lms3dPoint2& b = points[1];
  const lms3dPoint2& c = points[2];
  for (const double share : Shares)
  {
    places.push_back({ b[0] + share * (c[0] - b[0]), b[1] + share * (c[1] - b[1]) });
  }
  return places;
}

std::vector<lms3dPoint2> lms3dFindWaysOutwards(const std::array<lms3dPoint2, 3>& corners)
{
  const lms3dPoint2 first = GetRight(corners[0], corners[1]);
  const lms3dPoint2 second = GetRight(corners[1], corners[2]);
  std::vector<lms3dPoint2> ways;
  const lms3dPoint2 sum = { first[0] + second[0], first[1] + second[1] };
  const double cosine = std::hypot(sum[0], sum[1]) / 2.0;
  // Two corners at one place have no cosine.
  if (cosine >= SmallestCosine)
  {
    const double scale = std::min(LargestWay, 1.0 / cosine) / (2.0 * cosine);
    ways.push_back({ scale * sum[0], scale * sum[1] });
  }
  const double sine = first[0] * second[1] - first[1] * second[0];
  if (std::abs(sine) >= SmallestSineOfTurn)
  {
    const double length = std::copysign(std::min(LargestWay, 1.0 / std::abs(sine)), sine);
    ways.push_back({ -length * first[1], length * first[0] });
    ways.push_back({ length * second[1], -length * second[0] });
  }
  return ways;
}

// Corners that are far from sharp need no lengths.
bool lms3dIsSharpCorner(const std::array<lms3dPoint2, 3>& corners)
{
  const auto& [a, b, c] = corners;
  if (!MayTurnBack({ b[0] - a[0], b[1] - a[1] }, { c[0] - b[0], c[1] - b[1] }) ||
    lms3dGetOrientation(a, b, c) <= 0)
  {
    return false;
  }
  const lms3dPoint2 first = GetRight(a, b);
  const lms3dPoint2 second = GetRight(b, c);
  return std::hypot(first[0] + second[0], first[1] + second[1]) < 2.0 * SmallestSineOfCorner;
}
