// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DMapComparison.h"

#include "Comparison/lms3dComparison.h"
#include "Comparison/lms3dSurfaceSamples.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dErrorReport.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dProcesses.h"
#include "Scene/lms3dSceneTriangles.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <stdexcept>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkLMS3DMapComparison);

namespace
{
lms3dTriangleMesh Collect(vtkDataObject* data, const std::string& name, std::string& warning)
{
  lms3dSceneTriangles triangles = lms3dCollectTriangles(data, name);
  const std::string skipped = lms3dDescribeSkippedCells(triangles, name);
  lms3dDropTrianglesWithoutArea(triangles.Mesh);
  if (triangles.Mesh.Triangles.empty())
  {
    throw std::runtime_error(name +
      " has no triangles, so there is nothing to compare. Connect a data set with polygons. " +
      skipped);
  }
  warning += skipped;
  return std::move(triangles.Mesh);
}

bool HasCells(vtkInformationVector* input)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  return data && data->GetNumberOfElements(vtkDataObject::CELL) > 0;
}

// The process with the map compares. Throws in all processes if more than one has a part of the
// scene.
bool ComparesHere(const lms3dProcesses& processes, vtkInformationVector** inputVector)
{
  if (!processes.IsParallel())
  {
    return true;
  }
  const int withScene = processes.AllReduceCount(HasCells(inputVector[1]));
  if (withScene > 1)
  {
    throw std::runtime_error("The scene is spread over " + std::to_string(withScene) +
      " processes, and each would compare the map with its own piece alone. Compare in one "
      "process.");
  }
  return HasCells(inputVector[0]) || HasCells(inputVector[1]);
}
} // namespace

struct vtkLMS3DMapComparison::Internals
{
  static bool Compare(vtkLMS3DMapComparison* filter, const lms3dComparison& comparison,
    vtkInformationVector* sceneInput, vtkInformationVector* outputVector);
  static void SetResults(vtkLMS3DMapComparison* filter, const lms3dComparisonResults& results);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  lms3dErrorReport Errors;
};

vtkLMS3DMapComparison::vtkLMS3DMapComparison()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLMS3DMapComparison::~vtkLMS3DMapComparison() = default;

void vtkLMS3DMapComparison::SetController(vtkMultiProcessController* controller)
{
  if (this->Internal->Controller != controller)
  {
    this->Internal->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLMS3DMapComparison::GetController() const
{
  return this->Internal->Controller;
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

int vtkLMS3DMapComparison::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Any part of the map may be nearest to any part of the scene, so a process needs all that it
  // has.
  const lms3dProcesses processes(this->Internal->Controller);
  for (int port = 0; port < 3; ++port)
  {
    if (vtkInformation* input = inputVector[port]->GetInformationObject(0))
    {
      lms3dRequestPiece(processes.GetRank(), processes.GetCount(), input);
    }
  }
  return 1;
}

bool vtkLMS3DMapComparison::Internals::Compare(vtkLMS3DMapComparison* filter,
  const lms3dComparison& comparison, vtkInformationVector* sceneInput,
  vtkInformationVector* outputVector)
{
  bool isDone = false;
  lms3dThreads threads;
  threads.Run(filter->NumberOfThreads,
    [&]
    {
      std::string warning;
      lms3dTriangleMesh map = Collect(comparison.Map, "The map", warning);
      lms3dTriangleMesh scene = Collect(vtkDataObject::GetData(sceneInput), "The scene", warning);
      if (!warning.empty())
      {
        vtkWarningWithObjectMacro(filter, << warning);
      }
      lms3dComparisonResults results;
      isDone = comparison.Run(std::move(map), std::move(scene), lms3dReportTo(filter, 0.0, 1.0),
        vtkPolyData::GetData(outputVector, 0), vtkPolyData::GetData(outputVector, 1), results);
      SetResults(filter, results);
    });
  return isDone;
}

int vtkLMS3DMapComparison::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the filter, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  Internals::SetResults(this, lms3dComparisonResults());
  const lms3dProcesses processes(this->Internal->Controller);
  // The outputs are one piece; consumers that request another piece get an empty one.
  if (!processes.IsParallel() && !lms3dIsFirstPiece(lms3dGetRequestedOutput(request, outputVector)))
  {
    return 1;
  }
  const lms3dComparison comparison = { vtkPolyData::GetData(inputVector[0]),
    vtkPolyData::GetData(inputVector[2]), this->Tolerance, this->NumberOfSamples,
    { this->MinimumRange, this->MaximumRange } };
  const std::string failure = lms3dRunAndGetError(
    [&]
    {
      comparison.Check();
      bool isDone = true;
      const bool isMine = ComparesHere(processes, inputVector);
      processes.RunCollectively(
        [&] {
          isDone = !isMine || Internals::Compare(this, comparison, inputVector[1], outputVector);
        });
      if (processes.AnyOf(!isDone))
      {
        lms3dClearOutputs(outputVector);
      }
    },
    "There is not enough memory for the samples; reduce NumberOfSamples.");
  if (!failure.empty())
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return this->Internal->Errors.Report(this, failure, outputVector);
  }
  return 1;
}

void vtkLMS3DMapComparison::Internals::SetResults(
  vtkLMS3DMapComparison* filter, const lms3dComparisonResults& results)
{
  filter->MapToSceneMean = results.MapToScene.Mean;
  filter->MapToSceneRMS = results.MapToScene.RootMeanSquare;
  filter->MapToScenePercentile95 = results.MapToScene.Percentile95;
  filter->MapToSceneMaximum = results.MapToScene.Maximum;
  filter->SceneToMapMean = results.SceneToMap.Mean;
  filter->SceneToMapRMS = results.SceneToMap.RootMeanSquare;
  filter->SceneToMapPercentile95 = results.SceneToMap.Percentile95;
  filter->SceneToMapMaximum = results.SceneToMap.Maximum;
  filter->NormalErrorMean = results.NormalError.Mean;
  filter->NormalErrorRMS = results.NormalError.RootMeanSquare;
  filter->NormalErrorPercentile95 = results.NormalError.Percentile95;
  filter->NormalErrorMaximum = results.NormalError.Maximum;
  filter->Correctness = results.Correctness;
  filter->Completeness = results.Completeness;
  filter->FScore = results.FScore;
  filter->AreaInFreeSpace = results.AreaInFreeSpace;
  filter->ClosedGapAreaInFreeSpace = results.ClosedGapAreaInFreeSpace;
  filter->MapArea = results.MapArea;
  filter->VisibleArea = results.VisibleArea;
  filter->MapTriangles = static_cast<vtkIdType>(results.MapTriangles);
  filter->ReturnsWithinTolerance = results.ReturnsWithinTolerance;
  filter->LargestReturnDistance = results.LargestReturnDistance;
}

void vtkLMS3DMapComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << '\n';
  os << indent << "MinimumRange: " << this->MinimumRange << '\n';
  os << indent << "MaximumRange: " << this->MaximumRange << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
  os << indent << "Controller: " << this->GetController() << '\n';
  const auto errors =
    [&](const char* name, double mean, double rms, double percentile, double maximum)
  {
    os << indent << name << ": mean " << mean << ", RMS " << rms << ", 95 % " << percentile
       << ", maximum " << maximum << '\n';
  };
  errors("MapToScene", this->MapToSceneMean, this->MapToSceneRMS, this->MapToScenePercentile95,
    this->MapToSceneMaximum);
  errors("SceneToMap", this->SceneToMapMean, this->SceneToMapRMS, this->SceneToMapPercentile95,
    this->SceneToMapMaximum);
  errors("NormalError", this->NormalErrorMean, this->NormalErrorRMS, this->NormalErrorPercentile95,
    this->NormalErrorMaximum);
  os << indent << "Correctness: " << this->Correctness << '\n';
  os << indent << "Completeness: " << this->Completeness << '\n';
  os << indent << "FScore: " << this->FScore << '\n';
  os << indent << "AreaInFreeSpace: " << this->AreaInFreeSpace << '\n';
  os << indent << "ClosedGapAreaInFreeSpace: " << this->ClosedGapAreaInFreeSpace << '\n';
  os << indent << "MapArea: " << this->MapArea << '\n';
  os << indent << "VisibleArea: " << this->VisibleArea << '\n';
  os << indent << "MapTriangles: " << this->MapTriangles << '\n';
  os << indent << "ReturnsWithinTolerance: " << this->ReturnsWithinTolerance << '\n';
  os << indent << "LargestReturnDistance: " << this->LargestReturnDistance << '\n';
}
