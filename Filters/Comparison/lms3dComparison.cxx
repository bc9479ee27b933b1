// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dComparison.h"

#include "Comparison/lms3dComparisonOutput.h"
#include "Comparison/lms3dMapComparison.h"
#include "Comparison/lms3dSensorView.h"
#include "Comparison/lms3dSurfaceQuery.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
lms3dSurfaceQuery::Points GetPoints(vtkPolyData* data)
{
  lms3dSurfaceQuery::Points points(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

// Returns NaN for a vertex that is not finite.
std::vector<double> GetVertexErrors(
  const lms3dSurfaceQuery& scene, vtkPolyData* map, const lms3dProgress& progress)
{
  std::vector<double> errors = lms3dGetDistances(scene, GetPoints(map), progress);
  std::replace(errors.begin(), errors.end(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN());
  return errors;
}

std::string DescribeInvisibleScene(const lms3dVector& sensor)
{
  std::ostringstream text;
  text
    << "The sensor at " << sensor[0] << ' ' << sensor[1] << ' ' << sensor[2]
    << " sees nothing of the scene, so there is nothing to compare. Connect the scene that was "
    << "scanned, in the same coordinates, and a scan with more than one beam and one turn: other "
    << "scans cover no area.";
  return text.str();
}
} // namespace

void lms3dComparison::Check() const
{
  if (std::isnan(this->Tolerance))
  {
    throw std::runtime_error("Tolerance is not a number; 0 or more metres are expected.");
  }
  const double low = this->Limits.Minimum;
  const double high = this->Limits.Maximum;
  if (!(low >= 0.0 && low <= high && high > 0.0))
  {
    std::ostringstream text;
    text << "MinimumRange and MaximumRange are " << low << " and " << high
         << " m; 0 <= minimum <= maximum and 0 < maximum are expected.";
    throw std::runtime_error(text.str());
  }
}

bool lms3dComparison::Run(lms3dTriangleMesh mapMesh, lms3dTriangleMesh sceneMesh,
  const lms3dProgress& progress, vtkPolyData* mapWithErrors, vtkPolyData* scenePoints,
  lms3dComparisonResults& results) const
{
  try
  {
    const lms3dSurfaceQuery map(std::move(mapMesh), lms3dGetStepProgress(progress, 0.0, 0.15));
    const lms3dSurfaceQuery scene(std::move(sceneMesh), lms3dGetStepProgress(progress, 0.15, 0.3));
    return this->Compare(map, scene, progress, mapWithErrors, scenePoints, results);
  }
  catch (const lms3dBuildStopped&)
  {
    return false;
  }
}

bool lms3dComparison::Compare(const lms3dSurfaceQuery& map, const lms3dSurfaceQuery& scene,
  const lms3dProgress& progress, vtkPolyData* mapWithErrors, vtkPolyData* scenePoints,
  lms3dComparisonResults& results) const
{
  const lms3dSensorView view((this->Scan ? this->Scan : this->Map)->GetFieldData(), this->Limits);
  if (!progress(0.3))
  {
    return false;
  }
  const lms3dSceneErrors sceneErrors(
    map, scene, view, this->NumberOfSamples, lms3dGetStepProgress(progress, 0.3, 0.6));
  if (sceneErrors.Points.empty())
  {
    throw std::runtime_error(DescribeInvisibleScene(view.GetPosition()));
  }
  if (!progress(0.6))
  {
    return false;
  }
  const lms3dClosedBeams closedBeams(
    this->Map->GetFieldData(), (this->Scan ? this->Scan : this->Map)->GetFieldData());
  const lms3dMapErrors mapErrors(map, scene, view, closedBeams, this->Tolerance,
    this->NumberOfSamples, lms3dGetStepProgress(progress, 0.6, 0.8));
  const std::vector<double> vertexErrors =
    GetVertexErrors(scene, this->Map, lms3dGetStepProgress(progress, 0.8, 0.85));
  const std::vector<double> returnDistances =
    lms3dGetDistances(map, this->Scan ? GetPoints(this->Scan) : lms3dSurfaceQuery::Points(),
      lms3dGetStepProgress(progress, 0.85, 0.9));
  if (!progress(0.9))
  {
    return false;
  }
  results = lms3dSummarize(
    map.GetMesh(), mapErrors, scene.GetMesh(), sceneErrors, returnDistances, this->Tolerance);
  mapWithErrors->ShallowCopy(this->Map);
  lms3dAddErrors(map.GetMesh(), mapErrors, vertexErrors, mapWithErrors);
  lms3dAddResults(results, mapWithErrors->GetFieldData());
  lms3dFillScenePoints(sceneErrors, scenePoints);
  return true;
}
