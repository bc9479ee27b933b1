// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dRangeImage.h"
#include "Device/lms3dScanChecks.h"
#include "Device/lms3dScanGeometry.h"
#include "Device/lms3dTrajectory.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dBuiltScene.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dScanOutput.h"
#include "Scan/lms3dScanner.h"

#include <vtkDataSet.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkLMS3DScanFilter);

static_assert(static_cast<int>(vtkLMS3DScanFilter::EXACT) == lms3dRayCaster::EXACT &&
    static_cast<int>(vtkLMS3DScanFilter::FAST) == lms3dRayCaster::FAST &&
    static_cast<int>(vtkLMS3DScanFilter::ANGLE_SUM) == lms3dRayCaster::ANGLE_SUM &&
    static_cast<int>(vtkLMS3DScanFilter::MOLLER_TRUMBORE) == lms3dRayCaster::MOLLER_TRUMBORE &&
    static_cast<int>(vtkLMS3DScanFilter::STATIC_CELL_LOCATOR) ==
      lms3dRayCaster::STATIC_CELL_LOCATOR,
  "the property and the ray casters number the methods alike");

namespace
{
// What of the whole work building takes, in the eyes of the progress bar.
constexpr double BuildShare = 0.3;

using Pipeline = vtkStreamingDemandDrivenPipeline;
} // namespace

struct vtkLMS3DScanFilter::Internals
{
  /// Tables of sines and cosines are made for new angles only.
  const lms3dScanGeometry& GetGeometry(const vtkLMS3DScanFilter* filter)
  {
    const Angles angles = { filter->AlphaRange[0], filter->AlphaRange[1],
      static_cast<double>(filter->AlphaResolution), filter->BetaRange[0], filter->BetaRange[1],
      static_cast<double>(filter->BetaResolution) };
    if (!this->Geometry || angles != this->GeometryAngles)
    {
      this->Geometry = std::make_unique<lms3dScanGeometry>(
        filter->AlphaRange, filter->AlphaResolution, filter->BetaRange, filter->BetaResolution);
      this->GeometryAngles = angles;
    }
    return *this->Geometry;
  }

  /// Read anew where it or the filter has changed; throws where it is bad.
  const lms3dTrajectory& GetTrajectory(vtkPolyData* poses, vtkLMS3DScanFilter* filter)
  {
    if (!this->Trajectory || this->TrajectoryData != poses ||
      this->TrajectoryTime < std::max(poses->GetMTime(), filter->GetMTime()))
    {
      this->Trajectory = std::make_unique<lms3dTrajectory>(poses, filter->Orientation);
      this->TrajectoryData = poses;
      this->TrajectoryTime.Modified();
    }
    return *this->Trajectory;
  }

  /// The pose at the time asked for, and its own time; without a trajectory that is not a number.
  lms3dPose GetPose(
    vtkPolyData* poses, vtkLMS3DScanFilter* filter, vtkInformation* request, double& time)
  {
    if (!poses)
    {
      time = NAN;
      return lms3dPose::FromOrientation(filter->Position, filter->Orientation);
    }
    const lms3dTrajectory& trajectory = this->GetTrajectory(poses, filter);
    const int step = request->Has(Pipeline::UPDATE_TIME_STEP())
      ? trajectory.FindStep(request->Get(Pipeline::UPDATE_TIME_STEP()))
      : 0;
    time = trajectory.GetTimes()[step];
    return trajectory.GetPose(step);
  }

  vtkSmartPointer<vtkMultiProcessController> Controller;
  lms3dBuiltScene Scene;
  lms3dThreads Threads;
  lms3dScanOutput Output;

private:
  using Angles = std::array<double, 6>;

  std::unique_ptr<lms3dScanGeometry> Geometry;
  Angles GeometryAngles;
  std::unique_ptr<lms3dTrajectory> Trajectory;
  vtkSmartPointer<vtkPolyData> TrajectoryData;
  vtkTimeStamp TrajectoryTime;
};

vtkLMS3DScanFilter::vtkLMS3DScanFilter()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLMS3DScanFilter::~vtkLMS3DScanFilter() = default;

void vtkLMS3DScanFilter::SetController(vtkMultiProcessController* controller)
{
  if (this->Internal->Controller != controller)
  {
    this->Internal->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLMS3DScanFilter::GetController() const
{
  return this->Internal->Controller;
}

vtkMTimeType vtkLMS3DScanFilter::GetBuildTime() const
{
  return this->Internal->Scene.GetBuildTime();
}

vtkImageData* vtkLMS3DScanFilter::GetRangeImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

const char* vtkLMS3DScanFilter::GetIntersectionMethodAsString() const
{
  return GetIntersectionMethodName(this->IntersectionMethod);
}

int vtkLMS3DScanFilter::GetNumberOfIntersectionMethods()
{
  return lms3dRayCaster::GetNumberOfMethods();
}

const char* vtkLMS3DScanFilter::GetIntersectionMethodName(int method)
{
  const bool isMethod = method >= 0 && method < GetNumberOfIntersectionMethods();
  return isMethod ? lms3dRayCaster::GetMethodName(method) : nullptr;
}

int vtkLMS3DScanFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkLMS3DScanFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

std::string vtkLMS3DScanFilter::GetPropertyError() const
{
  const auto vector = [](const double v[3]) { return lms3dVector{ v[0], v[1], v[2] }; };
  std::string error = lms3dFindPoseError(vector(this->Position), vector(this->Orientation));
  if (error.empty())
  {
    error = lms3dFindAngleError(
      this->AlphaRange, this->AlphaResolution, this->BetaRange, this->BetaResolution);
  }
  return error.empty() ? lms3dFindLimitError(this->GetLimits()) : error;
}

lms3dRangeLimits vtkLMS3DScanFilter::GetLimits() const
{
  return { this->MinimumRange, this->MaximumRange };
}

int vtkLMS3DScanFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->GetNumberOfInputConnections(1) > 0 &&
    !this->PublishTimeSteps(inputVector, outputVector))
  {
    return 0;
  }
  // RequestData reports bad properties; an extent needs good ones.
  if (this->GetPropertyError().empty())
  {
    lms3dDescribeRangeImage(this->AlphaRange, this->AlphaResolution, this->BetaRange,
      this->BetaResolution, outputVector->GetInformationObject(1));
  }
  return 1;
}

bool vtkLMS3DScanFilter::PublishTimeSteps(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  lms3dUpdateInput(this, 1);
  vtkPolyData* poses = vtkPolyData::GetData(inputVector[1]);
  if (!poses)
  {
    // Of a composite the pipeline would scan once for each block.
    vtkErrorMacro("The trajectory is no vtkPolyData. Connect a polyline or points; of a composite "
                  "data set extract the block.");
    this->SetErrorCode(vtkErrorCode::UserError);
    lms3dClearOutputs(outputVector);
    return false;
  }
  try
  {
    const std::vector<double>& times = this->Internal->GetTrajectory(poses, this).GetTimes();
    lms3dSetTimeSteps(times, outputVector->GetInformationObject(0));
    lms3dSetTimeSteps(times, outputVector->GetInformationObject(1));
  }
  catch (const std::exception&)
  {
    // RequestData reports it.
  }
  return true;
}

int vtkLMS3DScanFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Every beam may meet any part of the scene, whatever part of the outputs is asked for.
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  const lms3dProcesses processes(this->Internal->Controller);
  lms3dRequestPiece(processes.GetRank(), processes.GetCount(), input);
  if (vtkInformation* trajectory = inputVector[1]->GetInformationObject(0))
  {
    lms3dRequestPiece(0, 1, trajectory);
  }
  return 1;
}

int vtkLMS3DScanFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  // An image keeps its arrays from one execution to the next.
  vtkImageData::GetData(outputVector, 1)->Initialize();
  vtkInformation* output = lms3dGetRequestedOutput(request, outputVector);
  // A scan is one piece; those who ask for another get an empty one.
  if (!lms3dProcesses(this->Internal->Controller).IsParallel() && !lms3dIsFirstPiece(output))
  {
    return 1;
  }
  std::string failure = this->GetPropertyError();
  if (failure.empty())
  {
    failure = lms3dRunAndGetError([&] { this->Scan(output, inputVector, outputVector); },
      "There is not enough memory for the scan. Simplify the scene, or lower the resolutions.");
  }
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  return 1;
}

void vtkLMS3DScanFilter::Scan(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const lms3dProcesses processes(this->Internal->Controller);
  lms3dPose pose;
  double time = NAN;
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        vtkPolyData* poses = vtkPolyData::GetData(inputVector[1]);
        pose = this->Internal->GetPose(poses, this, request, time);
      }
      this->Internal->GetGeometry(this);
      this->Build(vtkDataObject::GetData(inputVector[0]));
    });
  processes.Broadcast(pose, time);
  this->UpdateProgress(BuildShare);

  vtkPolyData* scan = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* image = vtkImageData::GetData(outputVector, 1);
  bool isDone = false;
  if (processes.IsParallel())
  {
    const int ghostLevels =
      outputVector->GetInformationObject(1)->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    isDone = this->CastInParallel(processes, pose, ghostLevels, scan, image);
  }
  else
  {
    isDone = this->CastAlone(pose, scan, image);
  }
  this->Internal->Output.Discard();
  if (!isDone)
  {
    lms3dClearOutputs(outputVector);
  }
  if (!std::isnan(time))
  {
    scan->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
}

void vtkLMS3DScanFilter::Build(vtkDataObject* scene)
{
  lms3dBuiltScene& built = this->Internal->Scene;
  if (!built.IsFor(scene, this->IntersectionMethod))
  {
    this->Internal->Threads.Run(
      this->NumberOfThreads, [&] { built.Build(scene, this->IntersectionMethod); });
    // Where nothing is left at all, an error says so.
    const bool others = lms3dProcesses(this->Internal->Controller).IsParallel();
    if ((built.GetCaster() || others) && !built.GetSkippedCells().empty())
    {
      vtkWarningMacro(<< built.GetSkippedCells());
    }
  }
}

bool vtkLMS3DScanFilter::CastAlone(const lms3dPose& pose, vtkPolyData* scan, vtkImageData* image)
{
  const lms3dRayCaster* caster = this->Internal->Scene.GetCaster();
  this->CheckScene(caster != nullptr);
  const lms3dScanGeometry& geometry = this->Internal->GetGeometry(this);
  const lms3dRangeLimits limits = this->GetLimits();
  const lms3dProgress progress = lms3dReportTo(this, BuildShare, 1.0);
  lms3dScanOutput& output = this->Internal->Output;
  bool isDone = false;
  this->Internal->Threads.Run(this->NumberOfThreads,
    [&]
    {
      isDone = output.Cast(*caster, geometry, pose, limits, progress);
      if (isDone)
      {
        output.FillScan(&caster->GetMesh(), geometry, pose, scan);
        output.FillRangeImage(geometry, image);
      }
    });
  return isDone;
}

// MPI wants to be called by the thread that it was started in, so outside of Run.
bool vtkLMS3DScanFilter::CastInParallel(const lms3dProcesses& processes, const lms3dPose& pose,
  int ghostLevels, vtkPolyData* scan, vtkImageData* image)
{
  const lms3dBuiltScene& built = this->Internal->Scene;
  const lms3dRayCaster* caster = built.GetCaster();
  this->CheckScene(processes.AnyOf(caster != nullptr));
  const std::int64_t firstCell =
    processes.GetFirstCellNumber(built.GetNumberOfCells(), built.HasGlobalIds(), built.HasVolume());
  const lms3dScanGeometry& geometry = this->Internal->GetGeometry(this);
  const lms3dRangeLimits limits = this->GetLimits();
  const lms3dProgress progress = lms3dReportTo(this, BuildShare, 1.0);
  lms3dScanOutput& output = this->Internal->Output;
  const auto run = [this](const auto& work)
  { this->Internal->Threads.Run(this->NumberOfThreads, work); };

  bool isStopped = false;
  processes.RunCollectively(
    [&] { run([&] { isStopped = !output.CastPart(caster, geometry, pose, limits, progress); }); });
  if (processes.AnyOf(isStopped))
  {
    return false;
  }
  output.ReduceToNearest(processes, caster, firstCell);
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        run([&] { output.FillScan(nullptr, geometry, pose, scan); });
      }
      output.FillRangeImagePiece(
        geometry, { processes.GetRank(), processes.GetCount(), ghostLevels }, image);
    });
  return true;
}

void vtkLMS3DScanFilter::CheckScene(bool hasTriangles) const
{
  const std::string& leftOut = this->Internal->Scene.GetSkippedCells();
  if (!hasTriangles)
  {
    throw std::runtime_error(leftOut.empty()
        ? "The scene has no polygons, so there is nothing to scan. Connect a data set with "
          "polygons, triangle strips or volume cells."
        : "There is nothing left to scan. " + leftOut);
  }
}

void vtkLMS3DScanFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&os](const double* v) { os << v[0] << ' ' << v[1] << ' ' << v[2] << '\n'; };
  const auto range = [&os](const double* v) { os << v[0] << " to " << v[1] << '\n'; };
  os << indent << "Position: ";
  vector(this->Position);
  os << indent << "Orientation: ";
  vector(this->Orientation);
  os << indent << "AlphaRange: ";
  range(this->AlphaRange);
  os << indent << "AlphaResolution: " << this->AlphaResolution << '\n';
  os << indent << "BetaRange: ";
  range(this->BetaRange);
  os << indent << "BetaResolution: " << this->BetaResolution << '\n';
  os << indent << "MinimumRange: " << this->MinimumRange << '\n';
  os << indent << "MaximumRange: " << this->MaximumRange << '\n';
  os << indent << "IntersectionMethod: " << this->GetIntersectionMethodAsString() << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
  os << indent << "Controller: " << this->GetController() << '\n';
  os << indent << "BuildTime: " << this->GetBuildTime() << '\n';
}
