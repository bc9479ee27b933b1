// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dPatchFit.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t SmallestCount = 6;
// Returns farther from a plane than this multiple of the root mean square do not belong to it.
constexpr double LargestShare = 2.5;
constexpr int Rounds = 4;
// With fewer, a plane through two columns of returns would fit without any error.
constexpr double SmallestKeptShare = 0.9;

lms3dVector GetMean(const lms3dLocalMap& map, const std::vector<int>& returns)
{
  lms3dVector sum = { 0.0, 0.0, 0.0 };
  for (int i : returns)
  {
    sum = lms3dAdd(sum, map.Returns[i].Point);
  }
  return lms3dScale(sum, 1.0 / static_cast<double>(returns.size()));
}
std::optional<lms3dFittedPlane> FitOnce(
  const lms3dLocalMap& map, const std::vector<int>& returns, double smallestWidth)
{
  if (returns.size() < SmallestCount)
  {
    return {};
  }
  const lms3dVector mean = GetMean(map, returns);
  double moments[3][3] = {};
  for (int i : returns)
  {
    const lms3dVector v = lms3dSubtract(map.Returns[i].Point, mean);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        moments[row][column] += v[row] * v[column] / static_cast<double>(returns.size());
      }
    }
  }
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
  if (lms3dDot(normal, map.Returns[returns.front()].Direction) > 0.0)
  {
    normal = lms3dScale(normal, -1.0);
  }
  return lms3dFittedPlane{ mean, normal, std::sqrt(std::max(0.0, values[least])) };
}

double GetCorrelation(
  const lms3dLocalMap& map, const std::vector<int>& returns, const lms3dFittedPlane& fit)
{
  double squares = 0.0;
  double products = 0.0;
  double last = 0.0;
  for (int i : returns)
  {
    const double distance = lms3dDot(fit.Normal, lms3dSubtract(map.Returns[i].Point, fit.Centre));
    squares += distance * distance;
    products += distance * last;
    last = distance;
  }
  return squares > 0.0 ? products / squares : 0.0;
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
  std::optional<lms3dFittedPlane> fit = FitOnce(map, returns, smallestWidth);
  std::vector<int> members = returns;
  for (int round = 0; fit && round < Rounds; ++round)
  {
    const double largest = LargestShare * fit->Deviation;
    std::vector<int> kept;
    for (int i : members)
    {
      if (std::abs(lms3dDot(fit->Normal, lms3dSubtract(map.Returns[i].Point, fit->Centre))) <=
        largest)
      {
        kept.push_back(i);
      }
    }
    const std::optional<lms3dFittedPlane> next = FitOnce(map, kept, smallestWidth);
    const bool isMost =
      static_cast<double>(kept.size()) >= SmallestKeptShare * static_cast<double>(returns.size());
    if (kept.size() == members.size() || !isMost || !next)
    {
      break;
    }
    fit = next;
    members = kept;
  }
  if (fit)
  {
    fit->Correlation = GetCorrelation(map, members, *fit);
  }
  return fit;
}
