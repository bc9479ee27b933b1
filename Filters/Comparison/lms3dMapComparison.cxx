// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dMapComparison.h"

#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dTriangleDistance.h"
#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <cmath>

namespace
{
// A point is visible if the beam towards it gets this far, as a share of its range. The rest allows
// for rounding at grazing angles.
constexpr double VisibleShareOfRange = 1.0 - 1e-6;

// Relative rounding of the side of a plane that the sensor is on.
constexpr double Rounding = 1e-12;

// Bounds the number of samples if the sensor sees little of the scene.
constexpr double MaximumSamplesPerVisibleSample = 32.0;

// Degrees, 0 to 90. Uses the arc tangent because an arc cosine is inaccurate for small angles.
double GetAngleBetweenPlanes(const lms3dVector& a, const lms3dVector& b)
{
  const lms3dVector cross = lms3dCross(a, b);
  return lms3dDegreesPerRadian *
    std::atan2(std::sqrt(lms3dDot(cross, cross)), std::abs(lms3dDot(a, b)));
}

// Returns false if the sensor is on the triangle's plane, within rounding.
bool FacesAway(const lms3dCorners& corners, const lms3dVector& normal, const lms3dVector& sensor)
{
  const lms3dVector toSensor =
    lms3dSubtract(sensor, { corners[0][0], corners[0][1], corners[0][2] });
  return lms3dDot(normal, toSensor) <
    -Rounding * std::sqrt(lms3dDot(normal, normal) * lms3dDot(toSensor, toSensor));
}

// Degrees, 0 to 180.
double GetNormalError(const lms3dCorners& map, const lms3dCorners& scene, const lms3dVector& sensor)
{
  const lms3dVector normal = lms3dGetWeightedNormal(map);
  const double angle = GetAngleBetweenPlanes(normal, lms3dGetWeightedNormal(scene));
  return FacesAway(map, normal, sensor) ? 180.0 - angle : angle;
}

std::vector<double> GetDistances(const std::vector<lms3dNearest>& nearest)
{
  std::vector<double> distances(nearest.size());
  std::transform(nearest.begin(), nearest.end(), distances.begin(),
    [](const lms3dNearest& each) { return each.Distance; });
  return distances;
}

// Returns the range at which a beam towards each point hits the scene, metres.
std::vector<double> GetRanges(const lms3dSurfaceQuery& scene, const lms3dSensorView& view, int way,
  const lms3dSurfaceQuery::Points& points, const lms3dProgress& progress)
{
  if (view.GetNumberOfWays() == 1)
  {
    return scene.GetRangesTowards(view.GetPosition(), points, progress);
  }
  lms3dSurfaceQuery::Points starts;
  starts.reserve(points.size());
  for (const lms3dVector& point : points)
  {
    starts.push_back(view.GetStart(point, way));
  }
  return scene.GetRangesTowards(starts, points, progress);
}

// Visits each way on which beams lead to the points, with the ranges at which they hit the scene.
template <typename Visitor>
void ForEachWay(const lms3dSurfaceQuery& scene, const lms3dSensorView& view,
  const lms3dSurfaceQuery::Points& points, const lms3dProgress& progress, const Visitor& visit)
{
  const int ways = view.GetNumberOfWays();
  for (int way = 0; way < ways; ++way)
  {
    const lms3dProgress part = lms3dGetStepProgress(
      progress, static_cast<double>(way) / ways, static_cast<double>(way + 1) / ways);
    visit(way, GetRanges(scene, view, way, points, part));
  }
}

// Where the sensor stands for the beam that leads to a point.
lms3dVector GetSensor(const lms3dSensorView& view, const lms3dVector& point)
{
  const bool isSecond = view.GetNumberOfWays() == 2 && !view.Covers(point) && view.Covers(point, 1);
  return view.GetStart(point, isSecond ? 1 : 0);
}

// Returns the samples of the scene that the sensor sees.
lms3dSurfaceQuery::Points GetVisible(const lms3dSurfaceQuery& scene, const lms3dSensorView& view,
  std::int64_t count, const lms3dProgress& progress)
{
  const lms3dSurfaceSamples samples(scene.GetMesh(), count);
  std::vector<bool> isVisible(samples.Points.size(), false);
  ForEachWay(scene, view, samples.Points, progress,
    [&](int way, const std::vector<double>& ranges)
    {
      for (std::size_t i = 0; i < ranges.size(); ++i)
      {
        const lms3dVector& point = samples.Points[i];
        isVisible[i] = isVisible[i] ||
          (view.Covers(point, way) && ranges[i] >= VisibleShareOfRange * view.GetRange(point, way));
      }
    });
  lms3dSurfaceQuery::Points visible;
  for (std::size_t i = 0; i < isVisible.size(); ++i)
  {
    if (isVisible[i])
    {
      visible.push_back(samples.Points[i]);
    }
  }
  return visible;
}

bool IsInClosedGap(
  const lms3dSensorView& view, const lms3dClosedBeams& closedBeams, const lms3dVector& point)
{
  for (int way = 0; !closedBeams.IsEmpty() && way < view.GetNumberOfWays(); ++way)
  {
    for (const auto& [alpha, beta] : view.GetAngles(point, way))
    {
      if (closedBeams.AreBeside(alpha, beta))
      {
        return true;
      }
    }
  }
  return false;
}

double GetShare(std::size_t part, std::size_t whole)
{
  return static_cast<double>(part) / static_cast<double>(whole);
}
} // namespace

std::vector<double> lms3dGetDistances(const lms3dSurfaceQuery& surface,
  const lms3dSurfaceQuery::Points& points, const lms3dProgress& progress)
{
  return GetDistances(surface.FindNearest(points, progress));
}

lms3dMapErrors::lms3dMapErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
  const lms3dSensorView& view, const lms3dClosedBeams& closedBeams, double tolerance,
  std::int64_t count, const lms3dProgress& progress)
  : Samples(map.GetMesh(), count)
{
  const std::vector<lms3dNearest> nearest =
    scene.FindNearest(this->Samples.Points, lms3dGetStepProgress(progress, 0.0, 0.8));
  std::vector<bool> isInFront(nearest.size(), false);
  ForEachWay(scene, view, this->Samples.Points, lms3dGetStepProgress(progress, 0.8, 1.0),
    [&](int way, const std::vector<double>& ranges)
    {
      for (std::size_t i = 0; i < ranges.size(); ++i)
      {
        const lms3dVector& point = this->Samples.Points[i];
        isInFront[i] = isInFront[i] ||
          (view.Covers(point, way) && view.GetRange(point, way) + tolerance < ranges[i]);
      }
    });
  this->Distances = GetDistances(nearest);
  this->Angles.resize(nearest.size());
  std::size_t samplesInFreeSpace = 0;
  std::size_t samplesOfClosedGaps = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    this->Angles[i] = GetNormalError(lms3dGetCorners(map.GetMesh(), this->Samples.Triangles[i]),
      lms3dGetCorners(scene.GetMesh(), nearest[i].Triangle),
      GetSensor(view, this->Samples.Points[i]));
    if (isInFront[i] && nearest[i].Distance > tolerance)
    {
      const bool isInGap = IsInClosedGap(view, closedBeams, this->Samples.Points[i]);
      ++(isInGap ? samplesOfClosedGaps : samplesInFreeSpace);
    }
  }
  this->ShareInFreeSpace = GetShare(samplesInFreeSpace, nearest.size());
  this->ShareOfClosedGapsInFreeSpace = GetShare(samplesOfClosedGaps, nearest.size());
}

lms3dSceneErrors::lms3dSceneErrors(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
  const lms3dSensorView& view, std::int64_t count, const lms3dProgress& progress)
  : Points(GetVisible(scene, view, count, lms3dGetStepProgress(progress, 0.0, 0.2)))
  , VisibleShare(GetShare(this->Points.size(), count))
{
  if (this->VisibleShare < 1.0)
  {
    const double samples =
      count / std::max(this->VisibleShare, 1.0 / MaximumSamplesPerVisibleSample);
    const std::int64_t refined = static_cast<std::int64_t>(std::ceil(samples));
    this->Points = GetVisible(scene, view, refined, lms3dGetStepProgress(progress, 0.2, 0.4));
    this->VisibleShare = GetShare(this->Points.size(), refined);
  }
  this->Distances = lms3dGetDistances(map, this->Points, lms3dGetStepProgress(progress, 0.4, 1.0));
}
