// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityRivals.h"

#include <vtkCellLocator.h>
#include <vtkCellTreeLocator.h>
#include <vtkModifiedBSPTree.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace
{
// Metres, as vtkLMS3DScanFilter's StaticCellLocator has.
constexpr double CommonTolerance = 1e-9;

// The length of a line, relative to the distance of the farthest corner from the sensor.
constexpr double Reach = 2.0;

double GetLargestDistance(const std::vector<Vector>& points, const Vector& sensor)
{
  double largest = 0.0;
  for (const Vector& point : points)
  {
    const double distance = GetLength(point - sensor);
    largest = std::isfinite(distance) ? std::max(largest, distance) : largest;
  }
  return largest;
}

template <typename LocatorT>
class LineCaster
{
public:
  LineCaster(const lms3dTriangleMesh& mesh, double tolerance)
    : Points(mesh.Points.begin(), mesh.Points.end())
    , Tolerance(tolerance)
  {
    this->Locator->SetDataSet(MakeSurface(mesh));
    this->Locator->BuildLocator();
  }

  std::vector<double> Cast(const std::vector<StabilityShot>& shots) const
  {
    std::vector<double> ranges;
    ranges.reserve(shots.size() * lms3dBeamPacket::Size);
    Vector sensor = {};
    double length = 0.0;
    for (const StabilityShot& shot : shots)
    {
      if (ranges.empty() || shot.Sensor != sensor)
      {
        sensor = shot.Sensor;
        length = Reach * GetLargestDistance(this->Points, sensor);
      }
      for (const Vector& direction : shot.Directions)
      {
        ranges.push_back(this->GetRange(sensor, direction, length));
      }
    }
    return ranges;
  }

private:
  double GetRange(const Vector& sensor, const Vector& direction, double length) const
  {
    const Vector end = sensor + length * direction;
    double t = 0.0;
    double point[3];
    double place[3];
    int part = 0;
    const int isHit = this->Locator->IntersectWithLine(
      sensor.data(), end.data(), this->Tolerance, t, point, place, part);
    return isHit ? t * length : std::numeric_limits<double>::infinity();
  }

  const std::vector<Vector> Points;
  const double Tolerance;
  const vtkNew<LocatorT> Locator;
};

template <typename LocatorT>
StabilityMethod MakeLocator(const std::string& name, double tolerance)
{
  return { name,
    [tolerance](const lms3dTriangleMesh& mesh) -> StabilityCaster
    {
      const auto caster = std::make_shared<const LineCaster<LocatorT>>(mesh, tolerance);
      return [caster](const std::vector<StabilityShot>& shots) { return caster->Cast(shots); };
    } };
}
} // namespace

std::vector<StabilityMethod> GetLocatorMethods()
{
  return { MakeLocator<vtkStaticCellLocator>("vtkStaticCellLocator", CommonTolerance),
    MakeLocator<vtkStaticCellLocator>("vtkStaticCellLocator at 0", 0.0),
    MakeLocator<vtkCellLocator>("vtkCellLocator", CommonTolerance),
    MakeLocator<vtkCellTreeLocator>("vtkCellTreeLocator", CommonTolerance),
    MakeLocator<vtkModifiedBSPTree>("vtkModifiedBSPTree", CommonTolerance),
    MakeLocator<vtkOBBTree>("vtkOBBTree", CommonTolerance) };
}
