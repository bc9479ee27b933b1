// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dReturnPlane.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>

namespace
{
/// The means of some returns.
struct Means
{
  lms3dVector Centre = { 0.0, 0.0, 0.0 };
  /// Against the beams.
  lms3dVector Back = { 0.0, 0.0, 0.0 };
};

Means FindMeans(const std::vector<lms3dMappedReturn>& returns, const std::vector<int>& numbers)
{
  const double scale = 1.0 / static_cast<double>(numbers.size());
  Means means;
  for (const int i : numbers)
  {
    means.Centre = lms3dAdd(means.Centre, lms3dScale(returns[i].Point, scale));
    means.Back = lms3dSubtract(means.Back, lms3dScale(returns[i].Direction, scale));
  }
  return means;
}

/// The directions in which returns spread, the least first.
struct Axes
{
  std::array<lms3dVector, 3> Directions;
  /// The mean squares, square metres.
  std::array<double, 3> Squares;
};

Axes FindAxes(const std::vector<lms3dMappedReturn>& returns, const std::vector<int>& numbers,
  const lms3dVector& centre)
{
  double moments[3][3] = {};
  for (const int number : numbers)
  {
    const lms3dVector v = lms3dSubtract(returns[number].Point, centre);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        moments[i][j] += v[i] * v[j] / static_cast<double>(numbers.size());
      }
    }
  }
  double values[3];
  double vectors[3][3];
  vtkMath::Diagonalize3x3(moments, values, vectors);
  std::array<int, 3> order = { 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  Axes axes;
  for (int i = 0; i < 3; ++i)
  {
    axes.Directions[i] = { vectors[0][order[i]], vectors[1][order[i]], vectors[2][order[i]] };
    axes.Squares[i] = values[order[i]];
  }
  return axes;
}
} // namespace

std::optional<lms3dReturnPlane> lms3dFitReturns(
  const std::vector<lms3dMappedReturn>& returns, const std::vector<int>& numbers, double width)
{
  const Means means = FindMeans(returns, numbers);
  const Axes axes = FindAxes(returns, numbers, means.Centre);
  lms3dVector normal = means.Back;
  if (axes.Squares[1] > width * width)
  {
    normal = axes.Directions[0];
  }
  else if (axes.Squares[2] > width * width)
  {
    const lms3dVector line = lms3dNormalize(axes.Directions[2]);
    normal = lms3dSubtract(means.Back, lms3dScale(line, lms3dDot(means.Back, line)));
  }
  const double length = lms3dGetLength(normal);
  if (!(length > lms3dReturnPlane::SmallestCosine))
  {
    return {};
  }
  const double sign = lms3dDot(normal, means.Back) < 0.0 ? -1.0 : 1.0;
  return lms3dReturnPlane{ means.Centre, lms3dScale(normal, sign / length) };
}
