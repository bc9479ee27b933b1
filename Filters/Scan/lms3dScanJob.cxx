// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanJob.h"

#include "Pipeline/lms3dPipelineRequests.h"
#include "Scan/lms3dBeamCasting.h"
#include "Scan/lms3dEmptyArrays.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dPoseArrays.h"
#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <memory>

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
  const lms3dScanStart& Start;

  /// Null if nothing needs them.
  const lms3dMovingBeams* const Beams;

  const lms3dProgress Progress;
  vtkPolyData* const Points;
  vtkImageData* const Image;
};

bool lms3dScanJob::Run(const lms3dScanJobRequest& request)
{
  const lms3dProcesses processes(request.Controller);
  lms3dScanStart start;
  const bool isPrepared = this->Prepare(request, processes, start);
  vtkPolyData* points = vtkPolyData::GetData(request.Outputs, 0);
  vtkImageData* image = vtkImageData::GetData(request.Outputs, 1);
  bool isDone = false;
  if (isPrepared)
  {
    const lms3dScanGeometry& geometry = this->Sensor.GetGeometry(request.Settings);
    std::unique_ptr<const lms3dMovingBeams> beams;
    processes.RunCollectively([&] { beams = start.MakeBeams(request.Settings, geometry); });
    const Scan scan = { request, processes, geometry, start, beams.get(),
      lms3dGetStepProgress(request.Progress, BuildShare, 1.0), points, image };
    isDone = processes.IsParallel() ? this->CastInParallel(scan) : this->CastAlone(scan);
    this->Output.Discard();
    this->Detection.Discard();
    if (request.Settings.SurfaceAttributes)
    {
      points->GetPointData()->SetActiveNormals("Normals");
    }
  }
  if (!isDone)
  {
    lms3dClearOutputs(request.Outputs);
  }
  start.SetDataTime(points);
  start.SetDataTime(image);
  return isDone;
}

// Finds the start and the tables of angles, and builds the scene. Returns false, in all processes, if the
// build was stopped in one of them.
bool lms3dScanJob::Prepare(
  const lms3dScanJobRequest& request, const lms3dProcesses& processes, lms3dScanStart& start)
{
  bool isBuilt = false;
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        start =
          this->Sensor.GetStart(request.Settings, request.Trajectory, *request.RequestedOutput);
      }
      this->Sensor.GetGeometry(request.Settings);
      isBuilt = this->Build(request, processes.IsParallel());
    });
  start.Broadcast(processes);
  return !processes.AnyOf(!isBuilt);
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
  this->Detection.ReadReflectances(request.Settings, this->Scene, request.Scene);
  return request.Progress(BuildShare);
}

bool lms3dScanJob::CastAlone(const Scan& scan)
{
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  lms3dCheckScene(caster != nullptr, this->Scene.GetPart(), this->Scene.GetSkippedCells());
  this->WarnIfIncomplete(this->Scene.GetPart(), scan);
  if (!this->CastAndDetect(scan, 0))
  {
    return false;
  }
  this->Threads.Run(scan.Request.Settings.NumberOfThreads,
    [&]
    {
      this->Output.FillScan(&caster->GetMesh(), scan.Geometry, scan.Start.Pose, scan.Points);
      AddPoses(scan);
      this->Output.FillRangeImage(scan.Geometry, scan.Image);
      this->AddSurfaceAttributes(scan, scan.Points->GetPointData());
    });
  this->Detection.AddStatus(scan.Geometry, scan.Points, scan.Image);
  return true;
}

// In the following functions, collective calls stay outside of Threads.Run: MPI need not allow calls from
// other threads.
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
  if (!this->CastAndDetect(scan, cells.First))
  {
    return false;
  }
  this->FillOutputsInParallel(scan);
  return true;
}

// Returns false, in all processes, if the work was stopped in one of them.
bool lms3dScanJob::CastAndDetect(const Scan& scan, std::int64_t firstCell)
{
  const lms3dScanSettings& settings = scan.Request.Settings;
  const lms3dProgress progress = lms3dDetection::GetCastProgress(scan.Progress, settings);
  const lms3dBeamCastRequest cast = { this->Scene.GetCaster(), firstCell, scan.Geometry,
    scan.Start.Pose, scan.Start.HasPlainBeams(settings.Device) ? nullptr : scan.Beams,
    settings.Device.Footprint, settings.Limits, scan.Processes, this->Threads,
    settings.NumberOfThreads, progress };
  return lms3dCastBeams(cast, this->Output) &&
    this->Detection.Run(
      { settings, cast, scan.Beams, scan.Request.Controller, scan.Progress }, this->Output);
}

void lms3dScanJob::FillOutputsInParallel(const Scan& scan)
{
  const lms3dProcesses& processes = scan.Processes;
  const lms3dScanSettings& settings = scan.Request.Settings;
  const auto run = [&](const auto& work) { this->Threads.Run(settings.NumberOfThreads, work); };
  vtkInformation* image = scan.Request.Outputs->GetInformationObject(1);
  const lms3dImagePiece piece = { processes.GetRank(), processes.GetCount(),
    image->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) };
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        run(
          [&]
          {
            this->Output.FillScan(nullptr, scan.Geometry, scan.Start.Pose, scan.Points);
            AddPoses(scan);
          });
      }
      this->Output.FillRangeImagePiece(scan.Geometry, piece, scan.Image);
      this->Detection.AddStatus(
        scan.Geometry, processes.IsFirst() ? scan.Points : nullptr, scan.Image);
    });
  if (lms3dSurfaceArrays(settings).AreAny())
  {
    vtkNew<vtkFieldData> own;
    processes.RunCollectively([&] { run([&] { this->AddSurfaceAttributes(scan, own); }); });
    lms3dGatherSurfaceAttributes(processes, this->Output.GetOwnTriangles(), own, scan.Points);
  }
  lms3dAddEmptyArrays(processes, scan.Points->GetPointData());
}

void lms3dScanJob::AddSurfaceAttributes(const Scan& scan, vtkFieldData* data) const
{
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  const lms3dSurfaceArrays wanted(scan.Request.Settings);
  if (wanted.AreAny() && caster)
  {
    lms3dAddSurfaceAttributes({ { caster->GetMesh(), this->Detection.GetReflectances() },
                                *scan.Beams, this->Output.GetOwnTriangles() },
      wanted, scan.Request.Scene, this->Scene.GetPart().HasGlobalIds, data);
  }
}

void lms3dScanJob::AddPoses(const Scan& scan)
{
  if (scan.Beams)
  {
    const lms3dDeviceSettings& device = scan.Request.Settings.Device;
    lms3dAddPoseArrays(*scan.Beams, device.Arrays, scan.Start.HasTurnPoses(device), scan.Points);
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
