// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScanTruth.h"

#include "ExactReference.h"
#include "Scenes.h"
#include "lms3dScanGeometry.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Beams = 361;
constexpr int Turns = 360;

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
} // namespace

ScanTruth::ScanTruth(const BenchmarkScene& scene, int beams, double maximumRange)
  : Step(std::max(1, Beams * Turns / beams))
{
  const ExactReference reference = MakeReference(scene.Surface);
  const double alphaRange[2] = { -90.0, 90.0 };
  const double betaRange[2] = { 0.0, 360.0 };
  const double upright[3] = { 0.0, 0.0, 0.0 };
  const lms3dScanGeometry geometry(alphaRange, Beams, betaRange, Turns);
  const lms3dPose pose = lms3dPose::FromOrientation(scene.Sensor.data(), upright);
  const lms3dBeamDirections directions(geometry, pose);
  for (std::size_t beam = 0; beam < Beams * Turns; beam += this->Step)
  {
    const double range =
      reference
        .Cast(scene.Sensor,
          directions.GetDirection(static_cast<int>(beam / Beams), static_cast<int>(beam % Beams)))
        .Range;
    this->Ranges.push_back(range <= maximumRange ? range : std::numeric_limits<double>::infinity());
  }
}

ScanErrors ScanTruth::GetErrors(vtkImageData* rangeImage) const
{
  const double* measured =
    vtkDoubleArray::SafeDownCast(rangeImage->GetPointData()->GetScalars())->GetPointer(0);
  ScanErrors errors;
  std::vector<double> relative;
  for (std::size_t i = 0; i < this->Ranges.size(); ++i)
  {
    const double range = measured[i * this->Step];
    const bool isHit = !std::isnan(range);
    const bool isTrueHit = std::isfinite(this->Ranges[i]);
    errors.Misses += isTrueHit && !isHit;
    errors.FalseHits += isHit && !isTrueHit;
    if (isHit && isTrueHit)
    {
      relative.push_back(std::abs(range - this->Ranges[i]) / this->Ranges[i]);
    }
  }
  std::sort(relative.begin(), relative.end());
  const bool isEmpty = relative.empty();
  const double none = std::numeric_limits<double>::quiet_NaN();
  errors.Median = isEmpty ? none : relative[relative.size() / 2];
  errors.Worst = isEmpty ? none : relative.back();
  return errors;
}
