// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "vtkLMS3DScanFilterInternals.h"

#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dRangeImage.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Scan/lms3dProcesses.h"

#include <vtkDataSet.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

vtkStandardNewMacro(vtkLMS3DScanFilter);

static_assert(static_cast<int>(vtkLMS3DScanFilter::EXACT) == lms3dRayCaster::EXACT &&
    static_cast<int>(vtkLMS3DScanFilter::FAST) == lms3dRayCaster::FAST &&
    static_cast<int>(vtkLMS3DScanFilter::ANGLE_SUM) == lms3dRayCaster::ANGLE_SUM &&
    static_cast<int>(vtkLMS3DScanFilter::MOLLER_TRUMBORE) == lms3dRayCaster::MOLLER_TRUMBORE &&
    static_cast<int>(vtkLMS3DScanFilter::STATIC_CELL_LOCATOR) ==
      lms3dRayCaster::STATIC_CELL_LOCATOR,
  "the property and the ray casters number the methods alike");

static_assert(
  static_cast<int>(vtkLMS3DScanFilter::YAWING) == static_cast<int>(lms3dMounting::Yawing) &&
    static_cast<int>(vtkLMS3DScanFilter::YAWING_TOP) ==
      static_cast<int>(lms3dMounting::YawingTop) &&
    static_cast<int>(vtkLMS3DScanFilter::PITCHING) == static_cast<int>(lms3dMounting::Pitching) &&
    static_cast<int>(vtkLMS3DScanFilter::ROLLING) == static_cast<int>(lms3dMounting::Rolling),
  "the property and the platform number the mountings alike");

vtkLMS3DScanFilter::vtkLMS3DScanFilter()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLMS3DScanFilter::~vtkLMS3DScanFilter()
{
  this->vtkLMS3DScanFilter::SetReflectanceArray(nullptr);
}

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
  return this->Internal->Job.GetBuildTime();
}

vtkImageData* vtkLMS3DScanFilter::GetRangeImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkLMS3DScanFilter::SetIntersectionMethod(int method)
{
  if (!GetIntersectionMethodName(method))
  {
    vtkErrorMacro("IntersectionMethod " << method << ": must be from " << EXACT << " (Exact) to "
                                        << STATIC_CELL_LOCATOR << " (StaticCellLocator). It stays "
                                        << this->GetIntersectionMethodAsString() << ".");
  }
  else if (this->IntersectionMethod != method)
  {
    this->IntersectionMethod = method;
    this->Modified();
  }
}

void vtkLMS3DScanFilter::SetMounting(int mounting)
{
  if (!GetMountingName(mounting))
  {
    vtkErrorMacro("Mounting " << mounting << ": must be from " << YAWING << " (Yawing) to "
                              << ROLLING << " (Rolling). It stays " << this->GetMountingAsString()
                              << ".");
  }
  else if (this->Mounting != mounting)
  {
    this->Mounting = mounting;
    this->Modified();
  }
}

const char* vtkLMS3DScanFilter::GetMountingAsString() const
{
  return GetMountingName(this->Mounting);
}

const char* vtkLMS3DScanFilter::GetMountingName(int mounting)
{
  constexpr const char* Names[] = { "Yawing", "YawingTop", "Pitching", "Rolling" };
  return mounting >= YAWING && mounting <= ROLLING ? Names[mounting] : nullptr;
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

vtkExecutive* vtkLMS3DScanFilter::CreateDefaultExecutive()
{
  return vtkStreamingDemandDrivenPipeline::New();
}

int vtkLMS3DScanFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    // RequestInformation refuses it, in words of its own.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
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

int vtkLMS3DScanFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const lms3dScanSettings settings = Internals::GetSettings(this);
  this->Internal->Wake(this, settings);
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    lms3dUpdateInput(this, 1);
    vtkPolyData* poses = vtkPolyData::GetData(inputVector[1]);
    if (!poses)
    {
      vtkErrorMacro("The trajectory is not a vtkPolyData. Connect a polyline or points. If it is a "
                    "composite data set, extract the block.");
      this->ErrorCode = vtkErrorCode::UserError;
      lms3dClearOutputs(outputVector);
      return 0;
    }
    this->Internal->PublishTimeSteps(poses, settings.Orientation, outputVector);
  }
  // RequestData reports bad properties. An extent needs good ones.
  if (lms3dFindSettingsError(settings).empty())
  {
    lms3dDescribeRangeImage(
      this->AlphaRange, this->AlphaResolution, this->BetaRange, this->BetaResolution, outputVector);
  }
  return 1;
}

int vtkLMS3DScanFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->Internal->Wake(this, Internals::GetSettings(this));
  // Every beam can hit any part of the scene, whichever part of the outputs is requested.
  vtkInformation* scene = inputVector[0]->GetInformationObject(0);
  const lms3dProcesses processes(this->Internal->Controller);
  lms3dRequestPiece(processes.GetRank(), processes.GetCount(), scene);
  if (vtkInformation* trajectory = inputVector[1]->GetInformationObject(0))
  {
    lms3dRequestPiece(0, 1, trajectory);
  }
  return 1;
}

int vtkLMS3DScanFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the filter, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  // An image that the pipeline empties keeps its scalars.
  vtkImageData::GetData(outputVector, 1)->GetPointData()->SetScalars(nullptr);
  vtkInformation* output = lms3dGetRequestedOutput(request, outputVector);
  vtkMultiProcessController* controller = this->Internal->Controller;
  // In one process the first piece is the whole scan, and other pieces are empty.
  if (!lms3dProcesses(controller).IsParallel() && !lms3dIsFirstPiece(output))
  {
    return 1;
  }
  const lms3dScanSettings settings = Internals::GetSettings(this);
  std::string error = lms3dFindSettingsError(settings);
  if (error.empty())
  {
    this->Internal->SceneTime = Internals::GetSceneTime(this);
    const auto warn = [this](const std::string& text) { vtkWarningMacro(<< text); };
    const lms3dScanJobRequest scan = { settings, controller, vtkDataObject::GetData(inputVector[0]),
      vtkPolyData::GetData(inputVector[1]), lms3dGetRequestedTime(output), outputVector,
      lms3dReportTo(this, 0.0, 1.0), warn };
    error = lms3dRunAndGetError([&] { this->Internal->Job.Run(scan); },
      "There is not enough memory for the scan. Simplify the scene, or lower the resolutions.");
  }
  if (!error.empty())
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return this->Internal->Errors.Report(this, error, outputVector);
  }
  return 1;
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
  os << indent << "SurfaceAttributes: " << this->SurfaceAttributes << '\n';
  os << indent << "Device: " << this->GetDevice() << '\n';
  os << indent << "Mounting: " << this->GetMountingAsString() << '\n';
  os << indent << "AxisOffset: ";
  vector(this->AxisOffset);
  os << indent << "TurnRate: " << this->TurnRate << '\n';
  os << indent << "MotionDuringScan: " << this->MotionDuringScan << '\n';
  os << indent << "BeamDiameter: " << this->BeamDiameter << '\n';
  os << indent << "BeamDivergence: " << this->BeamDivergence << '\n';
  os << indent << "BeamSamples: " << this->BeamSamples << '\n';
  os << indent << "PulseLength: " << this->PulseLength << '\n';
  os << indent << "RangeAtTenPercent: " << this->RangeAtTenPercent << '\n';
  os << indent
     << "ReflectanceArray: " << (this->ReflectanceArray ? this->ReflectanceArray : "(none)")
     << '\n';
  os << indent << "ComputeIncidence: " << this->ComputeIncidence << '\n';
  os << indent << "ComputeIntensity: " << this->ComputeIntensity << '\n';
  os << indent << "ComputeTime: " << this->ComputeTime << '\n';
  os << indent << "ComputeStatus: " << this->ComputeStatus << '\n';
  os << indent << "ComputePoses: " << this->ComputePoses << '\n';
  os << indent << "Controller: " << this->GetController() << '\n';
  os << indent << "BuildTime: " << this->GetBuildTime() << '\n';
}
