// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityRivals.h"

#include <vtkCellLocator.h>
#include <vtkCellTreeLocator.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Metres, as vtkLMS3DScanFilter's StaticCellLocator has.
constexpr double CommonTolerance = 1e-9;

// A line is cast so many times as far as the farthest corner is from the sensor.
constexpr double Reach = 2.0;

double GetLargestDistance(const lms3dTriangleMesh& mesh, const Vector& sensor)
{
  double largest = 0.0;
  for (const Vector& point : mesh.Points)
  {
    const double distance = GetLength(point - sensor);
    largest = std::isfinite(distance) ? std::max(largest, distance) : largest;
  }
  return largest;
}

template <typename LocatorT>
std::vector<double> CastWith(const StabilityCase& scene, double tolerance)
{
  vtkNew<LocatorT> locator;
  locator->SetDataSet(MakeSurface(scene.Mesh));
  locator->BuildLocator();
  std::vector<double> ranges;
  ranges.reserve(scene.Shots.size() * lms3dBeamPacket::Size);
  for (const StabilityShot& shot : scene.Shots)
  {
    const double length = Reach * GetLargestDistance(scene.Mesh, shot.Sensor);
    for (const Vector& direction : shot.Directions)
    {
      const Vector end = shot.Sensor + length * direction;
      double t = 0.0;
      double point[3];
      double place[3];
      int part = 0;
      const int isHit = locator->IntersectWithLine(
        shot.Sensor.data(), end.data(), tolerance, t, point, place, part);
      ranges.push_back(isHit ? t * length : std::numeric_limits<double>::infinity());
    }
  }
  return ranges;
}

template <typename LocatorT>
StabilityMethod MakeLocator(const std::string& name, double tolerance)
{
  return { name,
    [tolerance](const StabilityCase& scene) { return CastWith<LocatorT>(scene, tolerance); } };
}
} // namespace

std::vector<StabilityMethod> GetLocatorMethods()
{
  return { MakeLocator<vtkStaticCellLocator>("vtkStaticCellLocator", CommonTolerance),
    MakeLocator<vtkStaticCellLocator>("vtkStaticCellLocator at 0", 0.0),
    MakeLocator<vtkCellLocator>("vtkCellLocator", CommonTolerance),
    MakeLocator<vtkCellTreeLocator>("vtkCellTreeLocator", CommonTolerance),
    MakeLocator<vtkOBBTree>("vtkOBBTree", CommonTolerance) };
}
