// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dPatchFit.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace
{
constexpr std::size_t SmallestCount = 6;
// Returns farther from a plane than this multiple of the root mean square do not belong to it.
constexpr double LargestShare = 2.5;
constexpr int Rounds = 4;
// Larger patches are fitted to a part of their returns, at least half of this number.
constexpr std::size_t SufficientCount = 4096;
// A prime number, so that the returns of a sample lie anywhere in their fans.
constexpr std::size_t OffsetStep = 7919;
// With fewer, a plane through two columns of returns would fit without any error.
constexpr double SmallestKeptShare = 0.9;

lms3dVector GetMean(const std::vector<lms3dVector>& points)
{
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  for (const lms3dVector& point : points)
  {
    sum = lms3dAdd(sum, point);
  }
  return lms3dScale(sum, 1.0 / static_cast<double>(points.size()));
}

/// `direction` is that of a beam towards the plane.
std::optional<lms3dFittedPlane> FitOnce(
  const std::vector<lms3dVector>& points, const lms3dVector& direction, double smallestWidth)
{
  if (points.size() < SmallestCount)
  {
    return {};
  }
  const lms3dVector mean = GetMean(points);
  const auto count = static_cast<double>(points.size());
  // The symmetric matrix of moments, row by row, without what is left of the diagonal.
  std::array<double, 6> sums = {};
  for (const lms3dVector& point : points)
  {
    const lms3dVector v = lms3dSubtract(point, mean);
    const std::array<double, 6> a = { v[0], v[0], v[0], v[1], v[1], v[2] };
    const std::array<double, 6> b = { v[0], v[1], v[2], v[1], v[2], v[2] };
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] += a[i] * b[i] / count;
    }
  }
  double moments[3][3] = { { sums[0], sums[1], sums[2] }, { sums[1], sums[3], sums[4] },
    { sums[2], sums[4], sums[5] } };
  double values[3];
  double vectors[3][3];
  vtkMath::Diagonalize3x3(moments, values, vectors);
  std::array<int, 3> order = { 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  if (!(values[order[1]] >= smallestWidth * smallestWidth))
  {
    return {};
  }
  const int least = order[0];
  lms3dVector normal = lms3dNormalize({ vectors[0][least], vectors[1][least], vectors[2][least] });
  if (lms3dDot(normal, direction) > 0.0)
  {
    normal = lms3dScale(normal, -1.0);
  }
  return lms3dFittedPlane{ mean, normal, std::sqrt(std::max(0.0, values[least])) };
}

double GetDistance(const lms3dFittedPlane& fit, const lms3dVector& point)
{
  return lms3dDot(fit.Normal, lms3dSubtract(point, fit.Centre));
}

double GetCorrelation(const std::vector<lms3dVector>& points, const lms3dFittedPlane& fit)
{
  double squares = 0.0;
  double products = 0.0;
  double last = 0.0;
  for (const lms3dVector& point : points)
  {
    const double distance = GetDistance(fit, point);
    squares += distance * distance;
    products += distance * last;
    last = distance;
  }
  return squares > 0.0 ? products / squares : 0.0;
}

/// The returns that are near a plane. `returns` and `points` are in the same order.
struct Members
{
  std::vector<int> Returns;
  std::vector<lms3dVector> Points;
};

Members Keep(const Members& members, const lms3dFittedPlane& fit)
{
  const double largest = LargestShare * fit.Deviation;
  Members kept;
  kept.Returns.reserve(members.Returns.size());
  kept.Points.reserve(members.Points.size());
  for (std::size_t i = 0; i < members.Points.size(); ++i)
  {
    if (std::abs(GetDistance(fit, members.Points[i])) <= largest)
    {
      kept.Returns.push_back(members.Returns[i]);
      kept.Points.push_back(members.Points[i]);
    }
  }
  return kept;
}
} // namespace

std::vector<std::vector<int>> lms3dGetReturnsOfPatches(const lms3dLocalMap& map)
{
  std::vector<std::vector<int>> result(static_cast<std::size_t>(map.NumberOfPatches));
  for (std::size_t i = 0; i < map.Returns.size(); ++i)
  {
    const int patch = map.PatchIds[map.Returns[i].Triangle];
    if (patch >= 0)
    {
      result[patch].push_back(static_cast<int>(i));
    }
  }
  return result;
}

std::optional<lms3dFittedPlane> lms3dFitPlane(
  const lms3dLocalMap& map, const std::vector<int>& returns, double smallestWidth)
{
  const std::size_t step = returns.size() / SufficientCount + 1;
  Members members;
  // Not the same one of each few, which could all be of one beam of the fan.
  for (std::size_t i = 0; i + step <= returns.size(); i += step)
  {
    const int number = returns[i + i / step * OffsetStep % step];
    members.Returns.push_back(number);
    members.Points.push_back(map.Returns[number].Point);
  }
  const auto count = static_cast<double>(members.Returns.size());
  const auto fitTo = [&](const Members& some) -> std::optional<lms3dFittedPlane>
  {
    return some.Returns.empty()
      ? std::nullopt
      : FitOnce(some.Points, map.Returns[some.Returns.front()].Direction, smallestWidth);
  };
  std::optional<lms3dFittedPlane> fit = fitTo(members);
  for (int round = 0; fit && round < Rounds; ++round)
  {
    Members kept = Keep(members, *fit);
    const std::optional<lms3dFittedPlane> next = fitTo(kept);
    const bool isMost = static_cast<double>(kept.Points.size()) >= SmallestKeptShare * count;
    if (kept.Points.size() == members.Points.size() || !isMost || !next)
    {
      break;
    }
    fit = next;
    members = std::move(kept);
  }
  if (fit)
  {
    fit->Correlation = GetCorrelation(members.Points, *fit);
  }
  return fit;
}
