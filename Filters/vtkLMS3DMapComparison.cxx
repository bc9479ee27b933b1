// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DMapComparison.h"

#include "Comparison/lms3dComparisonOutput.h"
#include "Comparison/lms3dMapComparison.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dProcesses.h"
#include "Scene/lms3dSceneTriangles.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkLMS3DMapComparison);

namespace
{
lms3dTriangleMesh Collect(vtkDataObject* data, const std::string& what, std::string& leftOut)
{
  lms3dSceneTriangles triangles = lms3dCollectTriangles(data);
  const std::string words = lms3dDescribeSkippedCells(triangles, what);
  lms3dDropTrianglesWithoutArea(triangles.Mesh);
  if (triangles.Mesh.Triangles.empty())
  {
    throw std::runtime_error(what +
      " has no triangles, so there is nothing to compare. Connect a data set with polygons. " +
      words);
  }
  leftOut += words;
  return std::move(triangles.Mesh);
}

lms3dSurfaceQuery::Points GetPoints(vtkPolyData* data)
{
  lms3dSurfaceQuery::Points points(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

// A vertex that is not finite has no distance.
std::vector<double> GetVertexErrors(const lms3dSurfaceQuery& scene, vtkPolyData* map)
{
  std::vector<double> errors = lms3dGetDistances(scene, GetPoints(map));
  std::replace(errors.begin(), errors.end(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN());
  return errors;
}

bool HasCells(vtkDataObject* data)
{
  return data && data->GetNumberOfElements(vtkDataObject::CELL) > 0;
}

// Under MPI one process has the map, and has to have all of the scene.
bool IsForThisProcess(vtkInformationVector** inputVector)
{
  const lms3dProcesses processes(vtkMultiProcessController::GetGlobalController());
  const bool hasScene = HasCells(vtkDataObject::GetData(inputVector[1]));
  const int withScene = processes.AllReduceCount(hasScene);
  if (withScene > 1)
  {
    throw std::runtime_error("The scene is spread over " + std::to_string(withScene) +
      " processes, and each would compare the map with its own piece alone. Compare in one "
      "process.");
  }
  return !processes.IsParallel() || hasScene || HasCells(vtkDataObject::GetData(inputVector[0]));
}

std::string TellNothingSeen(const lms3dSensorView& view)
{
  std::ostringstream words;
  words << "The sensor at " << view.GetPosition()[0] << ' ' << view.GetPosition()[1] << ' '
        << view.GetPosition()[2] << " sees nothing of the scene, so there is nothing that the map "
        << "could show. Give the scene that was scanned, in the same coordinates, and a scan of "
        << "more than one beam and one turn: others cover no area.";
  return words.str();
}
} // namespace

vtkLMS3DMapComparison::vtkLMS3DMapComparison()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

int vtkLMS3DMapComparison::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 2 ? 1 : 0);
  return 1;
}

void vtkLMS3DMapComparison::CheckProperties() const
{
  if (std::isnan(this->Tolerance))
  {
    throw std::runtime_error("Tolerance is not a number; 0 or more metres are expected.");
  }
  if (!(this->MinimumRange >= 0.0 && this->MinimumRange <= this->MaximumRange &&
        this->MaximumRange > 0.0))
  {
    std::ostringstream words;
    words << "MinimumRange and MaximumRange are " << this->MinimumRange << " and "
          << this->MaximumRange << " m; 0 <= minimum <= maximum and 0 < maximum are expected.";
    throw std::runtime_error(words.str());
  }
}

void vtkLMS3DMapComparison::Compare(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const lms3dProgress goesOn = lms3dReportTo(this, 0.0, 1.0);
  vtkPolyData* mapInput = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* scan = vtkPolyData::GetData(inputVector[2]);
  std::string leftOut;
  const lms3dSurfaceQuery map(Collect(mapInput, "The map", leftOut));
  const lms3dSurfaceQuery scene(
    Collect(vtkDataObject::GetData(inputVector[1]), "The scene", leftOut));
  if (!leftOut.empty())
  {
    vtkWarningMacro(<< leftOut);
  }
  const lms3dSensorView view(
    (scan ? scan : mapInput)->GetFieldData(), { this->MinimumRange, this->MaximumRange });
  if (!goesOn(0.3))
  {
    return;
  }
  const lms3dSceneErrors sceneErrors(map, scene, view, this->NumberOfSamples);
  if (sceneErrors.Points.empty())
  {
    throw std::runtime_error(TellNothingSeen(view));
  }
  if (!goesOn(0.6))
  {
    return;
  }
  const lms3dMapErrors mapErrors(map, scene, view, this->Tolerance, this->NumberOfSamples);
  const std::vector<double> vertexErrors = GetVertexErrors(scene, mapInput);
  const std::vector<double> returnDistances =
    lms3dGetDistances(map, scan ? GetPoints(scan) : lms3dSurfaceQuery::Points());
  if (!goesOn(0.9))
  {
    return;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(mapInput);
  lms3dAddErrors(map.GetMesh(), mapErrors, vertexErrors, output);
  lms3dAddResults(map.GetMesh(), mapErrors, scene.GetMesh(), sceneErrors, returnDistances,
    this->Tolerance, output->GetFieldData());
  lms3dFillScenePoints(sceneErrors, vtkPolyData::GetData(outputVector, 1));
}

int vtkLMS3DMapComparison::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  const std::string failure = lms3dRunAndGetError(
    [&]
    {
      this->CheckProperties();
      if (IsForThisProcess(inputVector))
      {
        lms3dThreads threads;
        threads.Run(this->NumberOfThreads, [&] { this->Compare(inputVector, outputVector); });
      }
    },
    "There is not enough memory for so many samples; reduce NumberOfSamples.");
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  return 1;
}

void vtkLMS3DMapComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << '\n';
  os << indent << "MinimumRange: " << this->MinimumRange << '\n';
  os << indent << "MaximumRange: " << this->MaximumRange << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
}
