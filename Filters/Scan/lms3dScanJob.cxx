// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanJob.h"

#include "Pipeline/lms3dPipelineRequests.h"
#include "Scan/lms3dEmptyArrays.h"
#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <cstdint>

namespace
{
// The share of the progress bar for building.
constexpr double BuildShare = 0.3;

using Pipeline = vtkStreamingDemandDrivenPipeline;
} // namespace

/// One run: the request, and what all its steps use.
struct lms3dScanJob::Scan
{
  const lms3dScanJobRequest& Request;
  const lms3dProcesses& Processes;
  const lms3dScanGeometry& Geometry;
  const lms3dPose& Pose;
  const lms3dProgress Progress;
  vtkPolyData* const Points;
  vtkImageData* const Image;
};

bool lms3dScanJob::Run(const lms3dScanJobRequest& request)
{
  const lms3dProcesses processes(request.Controller);
  lms3dPose pose;
  double time = NAN;
  bool isBuilt = false;
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        pose = this->GetPose(request, time);
      }
      this->GetGeometry(request.Settings);
      isBuilt = this->Build(request, processes.IsParallel());
    });
  processes.Broadcast(pose, time);

  vtkPolyData* points = vtkPolyData::GetData(request.Outputs, 0);
  vtkImageData* image = vtkImageData::GetData(request.Outputs, 1);
  bool isDone = false;
  if (!processes.AnyOf(!isBuilt))
  {
    const Scan scan = { request, processes, this->GetGeometry(request.Settings), pose,
      lms3dGetStepProgress(request.Progress, BuildShare, 1.0), points, image };
    isDone = processes.IsParallel() ? this->CastInParallel(scan) : this->CastAlone(scan);
    this->Output.Discard();
    if (request.Settings.SurfaceAttributes)
    {
      points->GetPointData()->SetActiveNormals("Normals");
    }
  }
  if (!isDone)
  {
    lms3dClearOutputs(request.Outputs);
  }
  if (!std::isnan(time))
  {
    points->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  return isDone;
}

// Tables of sines and cosines are computed for new angles only.
const lms3dScanGeometry& lms3dScanJob::GetGeometry(const lms3dScanSettings& settings)
{
  const Angles angles = { settings.AlphaRange[0], settings.AlphaRange[1],
    static_cast<double>(settings.AlphaResolution), settings.BetaRange[0], settings.BetaRange[1],
    static_cast<double>(settings.BetaResolution) };
  if (!this->Geometry || angles != this->GeometryAngles)
  {
    this->Geometry = std::make_unique<lms3dScanGeometry>(settings.AlphaRange.data(),
      settings.AlphaResolution, settings.BetaRange.data(), settings.BetaResolution);
    this->GeometryAngles = angles;
  }
  return *this->Geometry;
}

const lms3dTrajectory& lms3dScanJob::GetTrajectory(
  vtkPolyData* poses, const lms3dVector& orientation)
{
  const vtkMTimeType time = poses->GetMTime();
  if (!this->Trajectory || this->TrajectoryData != poses || this->TrajectoryTime != time ||
    this->TrajectoryOrientation != orientation)
  {
    this->Trajectory = std::make_unique<lms3dTrajectory>(poses, orientation.data());
    this->TrajectoryData = poses;
    this->TrajectoryTime = time;
    this->TrajectoryOrientation = orientation;
  }
  return *this->Trajectory;
}

// The pose at the requested time, and its own time: NaN without a trajectory.
lms3dPose lms3dScanJob::GetPose(const lms3dScanJobRequest& request, double& time)
{
  const lms3dScanSettings& settings = request.Settings;
  if (!request.Trajectory)
  {
    time = NAN;
    return lms3dPose::FromOrientation(settings.Position.data(), settings.Orientation.data());
  }
  const lms3dTrajectory& trajectory = this->GetTrajectory(request.Trajectory, settings.Orientation);
  vtkInformation* output = request.RequestedOutput;
  const int step = output->Has(Pipeline::UPDATE_TIME_STEP())
    ? trajectory.FindStep(output->Get(Pipeline::UPDATE_TIME_STEP()))
    : 0;
  time = trajectory.GetTimes()[step];
  return trajectory.GetPose(step);
}

bool lms3dScanJob::Build(const lms3dScanJobRequest& request, bool isParallel)
{
  const lms3dProgress progress = lms3dGetStepProgress(request.Progress, 0.0, BuildShare);
  const vtkMTimeType lastBuild = this->GetBuildTime();
  bool isComplete = false;
  this->Threads.Run(request.Settings.NumberOfThreads,
    [&] { isComplete = this->Scene.Update(request.Scene, request.Settings.Method, progress); });
  if (!isComplete)
  {
    return false;
  }
  const std::string& skipped = this->Scene.GetSkippedCells();
  const bool isNew = this->GetBuildTime() != lastBuild || skipped != this->SkippedCells;
  // If no triangle is left in any process, an error says so.
  if (isNew && !skipped.empty() && (this->Scene.GetCaster() || isParallel))
  {
    request.Warn(skipped);
  }
  this->SkippedCells = skipped;
  return request.Progress(BuildShare);
}

bool lms3dScanJob::CastAlone(const Scan& scan)
{
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  lms3dCheckScene(caster != nullptr, this->Scene.GetPart(), this->Scene.GetSkippedCells());
  this->WarnIfIncomplete(this->Scene.GetPart(), scan);
  const lms3dScanSettings& settings = scan.Request.Settings;
  bool isDone = false;
  this->Threads.Run(settings.NumberOfThreads,
    [&]
    {
      isDone = this->Output.Cast(*caster, scan.Geometry, scan.Pose, settings.Limits, scan.Progress);
      if (isDone)
      {
        this->Output.FillScan(&caster->GetMesh(), scan.Geometry, scan.Pose, scan.Points);
        this->Output.FillRangeImage(scan.Geometry, scan.Image);
        this->AddSurfaceAttributes(scan, scan.Points->GetPointData());
      }
    });
  return isDone;
}

// Collective calls stay outside of Threads.Run: MPI need not allow calls from other threads.
bool lms3dScanJob::CastInParallel(const Scan& scan)
{
  const lms3dProcesses& processes = scan.Processes;
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  const lms3dProcesses::Cells cells = processes.GatherCells(this->Scene.GetPart());
  lms3dCheckScene(processes.AnyOf(caster != nullptr), cells.Whole, this->Scene.GetSkippedCells());
  if (processes.IsFirst())
  {
    this->WarnIfIncomplete(cells.Whole, scan);
  }
  const lms3dScanSettings& settings = scan.Request.Settings;
  const auto run = [&](const auto& work) { this->Threads.Run(settings.NumberOfThreads, work); };

  bool isStopped = false;
  processes.RunCollectively(
    [&]
    {
      run(
        [&]
        {
          isStopped = !this->Output.CastPart(
            caster, scan.Geometry, scan.Pose, settings.Limits, scan.Progress);
        });
    });
  if (processes.AnyOf(isStopped))
  {
    return false;
  }
  this->Output.ReduceToNearest(processes, caster, cells.First);
  vtkInformation* image = scan.Request.Outputs->GetInformationObject(1);
  const lms3dImagePiece piece = { processes.GetRank(), processes.GetCount(),
    image->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) };
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        run([&] { this->Output.FillScan(nullptr, scan.Geometry, scan.Pose, scan.Points); });
      }
      this->Output.FillRangeImagePiece(scan.Geometry, piece, scan.Image);
    });
  if (settings.SurfaceAttributes)
  {
    vtkNew<vtkFieldData> own;
    processes.RunCollectively([&] { run([&] { this->AddSurfaceAttributes(scan, own); }); });
    lms3dGatherSurfaceAttributes(processes, this->Output.GetOwnTriangles(), own, scan.Points);
  }
  lms3dAddEmptyArrays(processes, scan.Points->GetPointData());
  return true;
}

void lms3dScanJob::AddSurfaceAttributes(const Scan& scan, vtkFieldData* data) const
{
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  if (scan.Request.Settings.SurfaceAttributes && caster)
  {
    lms3dAddSurfaceAttributes(
      { caster->GetMesh(), scan.Geometry, scan.Pose, this->Output.GetOwnTriangles() },
      scan.Request.Scene, this->Scene.GetPart().HasGlobalIds, data);
  }
}

void lms3dScanJob::WarnIfIncomplete(const lms3dScenePart& scene, const Scan& scan)
{
  const std::string missing = lms3dDescribeMissingCells(scene);
  if (!missing.empty() && missing != this->MissingCells)
  {
    scan.Request.Warn(missing);
  }
  this->MissingCells = missing;
}
