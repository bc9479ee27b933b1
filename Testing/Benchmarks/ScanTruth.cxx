// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScanTruth.h"

#include "ExactReference.h"
#include "Scenes.h"
#include "ThinnedGrid.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
ExactReference MakeReference(vtkPolyData* surface)
{
  std::vector<ExactReference::Vector> points(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::vector<ExactReference::Triangle> triangles;
  triangles.reserve(surface->GetNumberOfPolys());
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* corners;
    it->GetCurrentCell(count, corners);
    triangles.push_back({ static_cast<std::uint32_t>(corners[0]),
      static_cast<std::uint32_t>(corners[1]), static_cast<std::uint32_t>(corners[2]) });
  }
  return { std::move(points), std::move(triangles) };
}

std::vector<std::size_t> Spread(std::size_t count)
{
  const std::size_t step = std::max<std::size_t>(1, ThinnedGrid::MaximumBeams / count);
  std::vector<std::size_t> beams;
  beams.reserve(ThinnedGrid::MaximumBeams / step + 1);
  for (std::size_t beam = 0; beam < ThinnedGrid::MaximumBeams; beam += step)
  {
    beams.push_back(beam);
  }
  return beams;
}

// The smallest number that at most a given number in a thousand exceed.
double GetPercentile(const std::vector<double>& sorted, std::size_t above)
{
  return sorted.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : sorted[sorted.size() - 1 - sorted.size() * above / 1000];
}
} // namespace

ScanTruth::ScanTruth(
  const BenchmarkScene& scene, std::vector<std::size_t> beams, double maximumRange)
  : Beams(std::move(beams))
  , MaximumRange(maximumRange)
{
  const ExactReference reference = MakeReference(scene.Surface);
  const std::vector<ExactReference::Vector> directions = ThinnedGrid::MakeDirections(scene);
  this->Ranges.reserve(this->Beams.size());
  for (std::size_t beam : this->Beams)
  {
    const double range = reference.Cast(scene.Sensor, directions[beam]).Range;
    this->Ranges.push_back(range <= maximumRange ? range : std::numeric_limits<double>::infinity());
  }
}

ScanTruth::ScanTruth(const BenchmarkScene& scene, int count, double maximumRange)
  : ScanTruth(scene, Spread(count), maximumRange)
{
}

int ScanTruth::GetNumberOfHits() const
{
  return static_cast<int>(std::count_if(
    this->Ranges.begin(), this->Ranges.end(), [](double range) { return std::isfinite(range); }));
}

ScanErrors ScanTruth::GetErrors(const double* ranges) const
{
  ScanErrors errors;
  std::vector<double> relative;
  relative.reserve(this->Beams.size());
  for (std::size_t i = 0; i < this->Beams.size(); ++i)
  {
    const double range = ranges[this->Beams[i]];
    const bool isHit = range <= this->MaximumRange;
    const bool isTrueHit = std::isfinite(this->Ranges[i]);
    errors.Misses += isTrueHit && !isHit;
    errors.FalseHits += isHit && !isTrueHit;
    if (isHit && isTrueHit)
    {
      relative.push_back(std::abs(range - this->Ranges[i]) / this->Ranges[i]);
    }
  }
  std::sort(relative.begin(), relative.end());
  errors.Median = GetPercentile(relative, 500);
  errors.Percentile999 = GetPercentile(relative, 1);
  errors.Worst = GetPercentile(relative, 0);
  return errors;
}

std::vector<double> ScanTruth::GetRanges() const
{
  std::vector<double> ranges(ThinnedGrid::MaximumBeams, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < this->Beams.size(); ++i)
  {
    ranges[this->Beams[i]] = this->Ranges[i];
  }
  return ranges;
}
