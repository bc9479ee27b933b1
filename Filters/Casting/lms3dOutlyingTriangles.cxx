// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dOutlyingTriangles.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace
{
constexpr std::size_t MaximumOutliers = 16;
constexpr double MinimumSizeRatio = 100.0;

// The median of a sample of this size does not move because of a few outliers.
constexpr std::size_t SampleSize = 1001;

// Enough for the preparations of a task to cost little.
constexpr std::size_t TrianglesOfTask = 4096;

/// The largest distance of a triangle's corners from the scene's median, along any axis, and the
/// triangle's index.
using Extent = std::pair<double, std::uint32_t>;

std::array<double, 3> GetMedian(const lms3dTriangleMesh& mesh)
{
  const std::size_t count = mesh.GetNumberOfTriangles();
  const std::size_t step = count / SampleSize + 1;
  std::array<double, 3> median;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> sample;
    for (std::size_t triangle = 0; triangle < count; triangle += step)
    {
      sample.push_back(mesh.GetCorner(triangle, 0)[axis]);
    }
    const auto half = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), half, sample.end());
    median[axis] = *half;
  }
  return median;
}

double GetExtent(
  const lms3dTriangleMesh& mesh, std::size_t triangle, const std::array<double, 3>& median)
{
  double extent = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* point = mesh.GetCorner(triangle, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      extent = std::max(extent, std::abs(point[axis] - median[axis]));
    }
  }
  return extent;
}

/// The triangles with the largest extents, the largest first: one more than there may be outliers.
struct Farthest
{
  double GetMinimum() const
  {
    return this->Extents.size() > MaximumOutliers ? this->Extents.back().first : -1.0;
  }

  void Add(const Extent& found)
  {
    if (found.first <= this->GetMinimum())
    {
      return;
    }
    this->Extents.insert(
      std::upper_bound(this->Extents.begin(), this->Extents.end(), found, std::greater<>()), found);
    if (this->Extents.size() > MaximumOutliers + 1)
    {
      this->Extents.pop_back();
    }
  }

  std::vector<Extent> Extents;
};

// If several triangles have the extent of the last one, it does not matter which of them are found.
std::vector<Extent> FindFarthest(const lms3dTriangleMesh& mesh)
{
  const std::array<double, 3> median = GetMedian(mesh);
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, mesh.GetNumberOfTriangles(), TrianglesOfTask), Farthest(),
    [&](const tbb::blocked_range<std::size_t>& range, Farthest farthest)
    {
      for (std::size_t triangle = range.begin(); triangle < range.end(); ++triangle)
      {
        farthest.Add({ GetExtent(mesh, triangle, median), static_cast<std::uint32_t>(triangle) });
      }
      return farthest;
    },
    [](Farthest a, const Farthest& b)
    {
      std::for_each(
        b.Extents.begin(), b.Extents.end(), [&a](const Extent& extent) { a.Add(extent); });
      return a;
    })
    .Extents;
}
} // namespace

std::vector<std::uint32_t> lms3dFindOutlyingTriangles(const lms3dTriangleMesh& mesh)
{
  const std::vector<Extent> farthest = FindFarthest(mesh);
  const auto rest = std::find_if(farthest.begin(), farthest.end(),
    [&](const Extent& extent)
    { return extent.first * MinimumSizeRatio <= farthest.front().first; });
  std::vector<std::uint32_t> outliers;
  if (rest != farthest.end())
  {
    std::transform(farthest.begin(), rest, std::back_inserter(outliers),
      [](const Extent& extent) { return extent.second; });
    std::sort(outliers.begin(), outliers.end());
  }
  return outliers;
}

std::vector<std::uint32_t> lms3dFindOtherTriangles(
  const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& outliers)
{
  std::vector<std::uint32_t> others;
  if (!outliers.empty())
  {
    std::vector<std::uint32_t> all(mesh.GetNumberOfTriangles());
    std::iota(all.begin(), all.end(), 0u);
    std::set_difference(
      all.begin(), all.end(), outliers.begin(), outliers.end(), std::back_inserter(others));
  }
  return others;
}
