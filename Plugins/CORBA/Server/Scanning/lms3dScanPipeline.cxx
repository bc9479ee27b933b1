// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dScanPipeline.h"

#include "Scanning/lms3dFilterOutputs.h"
#include "Scanning/lms3dFusedMapMaker.h"
#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

static_assert(static_cast<int>(LMS3D::MOUNTING_YAWING) == vtkLMS3DScanFilter::YAWING &&
    static_cast<int>(LMS3D::MOUNTING_YAWING_TOP) == vtkLMS3DScanFilter::YAWING_TOP &&
    static_cast<int>(LMS3D::MOUNTING_PITCHING) == vtkLMS3DScanFilter::PITCHING &&
    static_cast<int>(LMS3D::MOUNTING_ROLLING) == vtkLMS3DScanFilter::ROLLING,
  "the interface and the filter number the mountings alike");

namespace
{
bool HasErrors(const LMS3D::Device& device)
{
  return device.rangeBias != 0.0 || device.rangeNoise != 0.0 || device.rangeResolution != 0.0;
}
} // namespace

lms3dScanPipeline::lms3dScanPipeline(int threads)
  : Threads(threads)
{
  this->Scanner->SetNumberOfThreads(threads);
  lms3dAbortIf(this->Scanner, [this] { return this->ShouldAbort(); });
}

lms3dScanPipeline::~lms3dScanPipeline() = default;

std::shared_ptr<lms3dSnapshot> lms3dScanPipeline::Run(
  const lms3dScanSettings& settings, std::uint64_t number, const lms3dStopTest& isOutdated)
{
  this->IsOutdated = isOutdated;
  this->Aborted = false;
  this->Configure(settings);
  // VTK does not reset the flag after a filter was aborted.
  this->Scanner->SetAbortExecute(0);
  if (this->Errors)
  {
    this->Errors->SetAbortExecute(0);
  }
  if (this->Mapper)
  {
    this->Mapper->SetAbortExecute(0);
  }
  auto snapshot = std::make_shared<lms3dSnapshot>();
  snapshot->Header.number = number;
  snapshot->Header.generation = settings.Generation;
  snapshot->Header.scene = settings.Scene->Description.name;
  snapshot->Header.sensorPose = settings.Pose;
  snapshot->Header.settings = settings.Configuration;
  snapshot->Device = settings.Device;
  const bool isWhole =
    this->Scan(*snapshot) && (!settings.Configuration.makeMap || this->MakeMap(*snapshot));
  return isWhole ? snapshot : nullptr;
}

void lms3dScanPipeline::AddTo(
  lms3dFusedMapMaker& fusedMap, const lms3dScanSettings& settings, std::uint64_t number)
{
  fusedMap.Add(settings, number, this->Mapper ? this->Mapper->GetOutput() : nullptr,
    this->Errors ? this->Errors->GetOutput() : this->Scanner->GetOutput());
}

bool lms3dScanPipeline::ShouldAbort()
{
  if (this->Stopped || this->IsOutdated())
  {
    this->Aborted = true;
  }
  return this->Aborted;
}

void lms3dScanPipeline::PrepareErrors(const LMS3D::Device& device)
{
  if (!HasErrors(device))
  {
    this->Errors = nullptr;
    return;
  }
  if (!this->Errors)
  {
    this->Errors = vtkSmartPointer<vtkLMS3DRangeErrorFilter>::New();
    this->Errors->SetNumberOfThreads(this->Threads);
    this->Errors->SetInputConnection(this->Scanner->GetOutputPort());
    lms3dAbortIf(this->Errors, [this] { return this->ShouldAbort(); });
  }
  this->Errors->SetRangeBias(device.rangeBias);
  this->Errors->SetRangeNoise(device.rangeNoise);
  this->Errors->SetRangeResolution(device.rangeResolution);
  this->Errors->SetNoiseSeed(device.noiseSeed);
}

// The mapper keeps its memory for the next map. If that is much smaller or will not come, a new
// mapper gives the memory back.
void lms3dScanPipeline::PrepareMapper(const LMS3D::Configuration& configuration)
{
  const CORBA::ULongLong beams =
    CORBA::ULongLong(configuration.alpha.count) * configuration.beta.count;
  if (!configuration.makeMap || beams < this->MapperBeams / ReleaseFactor)
  {
    this->Mapper = nullptr;
    this->MapperBeams = 0;
  }
  if (!configuration.makeMap)
  {
    return;
  }
  if (!this->Mapper)
  {
    this->Mapper = vtkSmartPointer<vtkLMS3DSurfaceReconstructionFilter>::New();
    this->Mapper->SetNumberOfThreads(this->Threads);
    lms3dAbortIf(this->Mapper, [this] { return this->ShouldAbort(); });
  }
  this->MapperBeams = std::max(this->MapperBeams, beams);
  this->Mapper->SetInputConnection(
    this->Errors ? this->Errors->GetOutputPort() : this->Scanner->GetOutputPort());
  this->Mapper->SetMaximumError(configuration.mapError);
}

void lms3dScanPipeline::Configure(const lms3dScanSettings& settings)
{
  if (this->Scene != settings.Scene)
  {
    this->Scene = settings.Scene;
    this->Scanner->SetInputData(this->Scene->Surface);
  }
  const LMS3D::Pose& pose = settings.Pose;
  this->Scanner->SetPosition(pose.position.x, pose.position.y, pose.position.z);
  this->Scanner->SetOrientation(pose.orientation.x, pose.orientation.y, pose.orientation.z);

  const LMS3D::Configuration& configuration = settings.Configuration;
  this->Scanner->SetAlphaRange(configuration.alpha.start, configuration.alpha.stop);
  this->Scanner->SetAlphaResolution(static_cast<int>(configuration.alpha.count));
  this->Scanner->SetBetaRange(configuration.beta.start, configuration.beta.stop);
  this->Scanner->SetBetaResolution(static_cast<int>(configuration.beta.count));
  this->Scanner->SetMinimumRange(configuration.minimumRange);
  this->Scanner->SetMaximumRange(configuration.maximumRange);
  this->Scanner->SetIntersectionMethod(configuration.method == LMS3D::METHOD_FAST
      ? vtkLMS3DScanFilter::FAST
      : vtkLMS3DScanFilter::EXACT);
  this->ConfigureDevice(settings.Device);
  this->PrepareErrors(settings.Device);
  this->PrepareMapper(configuration);
}

void lms3dScanPipeline::ConfigureDevice(const LMS3D::Device& device)
{
  this->Scanner->SetBeamDiameter(device.beamDiameter);
  this->Scanner->SetBeamDivergence(device.beamDivergence);
  this->Scanner->SetBeamSamples(static_cast<int>(device.beamSamples));
  this->Scanner->SetPulseLength(device.pulseLength);
  this->Scanner->SetRangeAtTenPercent(device.rangeAtTenPercent);
  this->Scanner->SetReflectanceArray(device.reflectanceArray);
  this->Scanner->SetMounting(static_cast<int>(device.mounting));
  const LMS3D::Vector3& offset = device.axisOffset;
  this->Scanner->SetAxisOffset(offset.x, offset.y, offset.z);
  this->Scanner->SetTurnRate(device.turnRate);
  this->Scanner->SetComputeStatus(
    device.computeStatus || (this->FindsLostBeams && this->MayLoseBeams(device)));
}

bool lms3dScanPipeline::MayLoseBeams(const LMS3D::Device& device) const
{
  return device.rangeAtTenPercent > 0.0 || this->Scanner->GetMinimumRange() > 0.0 ||
    HasErrors(device);
}

bool lms3dScanPipeline::Update(vtkAlgorithm* algorithm, double& seconds) const
{
  lms3dAlgorithmMessages messages(algorithm);
  const auto start = std::chrono::steady_clock::now();
  algorithm->Update();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // The outputs of an aborted filter have no arrays.
  if (this->Aborted)
  {
    return false;
  }
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  return true;
}

// Modified(), because the loop scans again even if nothing has changed.
bool lms3dScanPipeline::Scan(lms3dSnapshot& snapshot)
{
  this->Scanner->Modified();
  if (!this->Update(this->Scanner, snapshot.ScanSeconds) || !this->AddErrors(snapshot))
  {
    return false;
  }
  if (this->Errors)
  {
    lms3dTakeScan(this->Errors->GetOutput(), this->Errors->GetRangeImage(), snapshot);
  }
  else
  {
    lms3dTakeScan(this->Scanner->GetOutput(), this->Scanner->GetRangeImage(), snapshot);
  }
  return true;
}

// The errors depend on the time of the scan, which a sensor at rest does not have.
bool lms3dScanPipeline::AddErrors(lms3dSnapshot& snapshot)
{
  if (!this->Errors)
  {
    return true;
  }
  this->Scanner->GetOutput()->GetInformation()->Set(
    vtkDataObject::DATA_TIME_STEP(), static_cast<double>(snapshot.Header.number));
  double seconds = 0.0;
  const bool isDone = this->Update(this->Errors, seconds);
  snapshot.ScanSeconds += seconds;
  return isDone;
}

bool lms3dScanPipeline::MakeMap(lms3dSnapshot& snapshot)
{
  if (!this->Update(this->Mapper, snapshot.MapSeconds))
  {
    return false;
  }
  lms3dTakeMap(this->Mapper->GetOutput(), snapshot);
  return true;
}
