// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dOutlyingTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>

namespace
{
constexpr std::size_t MostOutliers = 16;
constexpr double TimesSmaller = 100.0;

// Outliers among so many do not move their median.
constexpr std::size_t SampleSize = 1001;

/// How far a triangle reaches from the middle of the scene, and its number.
using Reach = std::pair<double, std::uint32_t>;

std::array<double, 3> GetMiddle(const lms3dTriangleMesh& mesh)
{
  const std::size_t count = mesh.GetNumberOfTriangles();
  const std::size_t step = count / SampleSize + 1;
  std::array<double, 3> middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> sample;
    for (std::size_t triangle = 0; triangle < count; triangle += step)
    {
      sample.push_back(mesh.GetCorner(triangle, 0)[axis]);
    }
    const auto median = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), median, sample.end());
    middle[axis] = *median;
  }
  return middle;
}

double GetReach(
  const lms3dTriangleMesh& mesh, std::size_t triangle, const std::array<double, 3>& middle)
{
  double reach = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* point = mesh.GetCorner(triangle, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      reach = std::max(reach, std::abs(point[axis] - middle[axis]));
    }
  }
  return reach;
}

/// Those that reach farthest, the farthest first: one more than there may be outliers.
std::vector<Reach> FindFarthest(const lms3dTriangleMesh& mesh)
{
  const std::array<double, 3> middle = GetMiddle(mesh);
  std::vector<Reach> farthest;
  double least = -1.0;
  for (std::size_t triangle = 0; triangle < mesh.GetNumberOfTriangles(); ++triangle)
  {
    const double reach = GetReach(mesh, triangle, middle);
    if (reach <= least)
    {
      continue;
    }
    const Reach found(reach, static_cast<std::uint32_t>(triangle));
    farthest.insert(
      std::upper_bound(farthest.begin(), farthest.end(), found, std::greater<>()), found);
    if (farthest.size() > MostOutliers + 1)
    {
      farthest.pop_back();
    }
    least = farthest.size() > MostOutliers ? farthest.back().first : -1.0;
  }
  return farthest;
}
} // namespace

std::vector<std::uint32_t> lms3dFindOutlyingTriangles(const lms3dTriangleMesh& mesh)
{
  const std::vector<Reach> farthest = FindFarthest(mesh);
  const auto rest = std::find_if(farthest.begin(), farthest.end(),
    [&](const Reach& reach) { return reach.first * TimesSmaller <= farthest.front().first; });
  std::vector<std::uint32_t> outliers;
  if (rest != farthest.end())
  {
    std::transform(farthest.begin(), rest, std::back_inserter(outliers),
      [](const Reach& reach) { return reach.second; });
    std::sort(outliers.begin(), outliers.end());
  }
  return outliers;
}
