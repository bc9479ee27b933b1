// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanJob.h"

#include "Pipeline/lms3dPipelineRequests.h"
#include "Scan/lms3dBeamCasting.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dPoseArrays.h"
#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <memory>
#include <optional>

namespace
{
// The share of the progress bar for building.
constexpr double BuildShare = 0.3;

// Returns whether threads that were woken for `a` serve `b` as well.
bool NeedTheSame(const lms3dScanSettings& a, const lms3dScanSettings& b)
{
  return a.Position == b.Position && a.Orientation == b.Orientation &&
    a.AlphaRange == b.AlphaRange && a.AlphaResolution == b.AlphaResolution &&
    a.BetaRange == b.BetaRange && a.BetaResolution == b.BetaResolution &&
    a.Device.Platform == b.Device.Platform && a.Limits.Maximum == b.Limits.Maximum &&
    a.Method == b.Method && a.NumberOfThreads == b.NumberOfThreads;
}
} // namespace

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

void lms3dScanJob::Wake(const lms3dScanSettings& settings, bool canPlan)
{
  if (this->Threads.AreAwake() && this->WokenSettings &&
    NeedTheSame(settings, *this->WokenSettings))
  {
    return;
  }
  this->EndWait();
  this->WokenSettings = settings;
  if (canPlan && this->CanPlan(settings))
  {
    this->Threads.Wake(settings.NumberOfThreads, [this] { this->MakePlan(*this->WokenSettings); });
  }
  else
  {
    this->Output.DiscardPlan();
    this->Threads.Wake(settings.NumberOfThreads);
  }
}

bool lms3dScanJob::HasPlan()
{
  this->EndWait();
  return this->Output.HasPlan();
}

void lms3dScanJob::EndWait()
{
  if (!this->Threads.EndWait())
  {
    this->Output.DiscardPlan();
  }
}

bool lms3dScanJob::CanPlan(const lms3dScanSettings& settings) const
{
  return this->Scene.GetCaster() && this->Scene.GetMethod() == settings.Method &&
    this->Sensor.HasGeometry(settings) && lms3dFindSettingsError(settings).empty() &&
    lms3dScanStart().HasPlainBeams(settings.Device);
}

void lms3dScanJob::MakePlan(const lms3dScanSettings& settings)
{
  try
  {
    const lms3dScanStart start = this->Sensor.GetStart(settings, nullptr, std::nullopt);
    this->Output.MakePlan(*this->Scene.GetCaster(), this->Sensor.GetGeometry(settings), start.Pose,
      settings.Limits.Maximum);
  }
  catch (...)
  {
    // The run makes its own plan, and reports what fails.
  }
}

// Finds the start and the tables of angles, and builds the scene. Returns false, in all processes,
// if the build was stopped in one of them.
bool lms3dScanJob::Prepare(
  const lms3dScanJobRequest& request, const lms3dProcesses& processes, lms3dScanStart& start)
{
  bool isBuilt = false;
  processes.RunCollectively(
    [&]
    {
      this->EndWait();
      const bool isUpToDate = this->Scene.IsUpToDate(request.Scene, request.Settings.Method);
      if (!isUpToDate || !this->Sensor.HasGeometry(request.Settings))
      {
        this->Output.DiscardPlan();
      }
      if (processes.IsFirst())
      {
        start = this->Sensor.GetStart(request.Settings, request.Trajectory, request.Time);
      }
      this->Sensor.GetGeometry(request.Settings);
      isBuilt = this->Build(request, isUpToDate, processes.IsParallel());
    });
  start.Broadcast(processes);
  return !processes.AnyOf(!isBuilt);
}

bool lms3dScanJob::Build(const lms3dScanJobRequest& request, bool isUpToDate, bool isParallel)
{
  const lms3dProgress progress = lms3dGetStepProgress(request.Progress, 0.0, BuildShare);
  const vtkMTimeType lastBuild = this->GetBuildTime();
  bool isComplete = isUpToDate;
  if (!isUpToDate)
  {
    this->Threads.Run(request.Settings.NumberOfThreads,
      [&] { isComplete = this->Scene.Update(request.Scene, request.Settings.Method, progress); });
  }
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

bool lms3dScanJob::CastRanges(
  const lms3dScanJobRequest& request, vtkDoubleArray* ranges, vtkUnsignedCharArray* status)
{
  const lms3dProcesses alone(nullptr);
  lms3dScanStart start;
  if (!this->Prepare(request, alone, start))
  {
    return false;
  }
  const lms3dScanGeometry& geometry = this->Sensor.GetGeometry(request.Settings);
  const auto beams = start.MakeBeams(request.Settings, geometry);
  const bool isDone = this->CastWhole({ request, alone, geometry, start, beams.get(),
    lms3dGetStepProgress(request.Progress, BuildShare, 1.0), nullptr, nullptr });
  if (isDone)
  {
    this->Output.CopyRanges(ranges);
    this->Detection.CopyStatus(status);
  }
  this->Output.Discard();
  this->Detection.Discard();
  return isDone;
}

bool lms3dScanJob::CastWhole(const Scan& scan)
{
  lms3dCheckScene(
    this->Scene.GetCaster() != nullptr, this->Scene.GetPart(), this->Scene.GetSkippedCells());
  this->WarnIfIncomplete(this->Scene.GetPart(), scan);
  return this->CastAndDetect(scan, 0);
}

bool lms3dScanJob::CastAlone(const Scan& scan)
{
  if (!this->CastWhole(scan))
  {
    return false;
  }
  const lms3dTriangleMesh& mesh = this->Scene.GetCaster()->GetMesh();
  this->Threads.Run(scan.Request.Settings.NumberOfThreads,
    [&]
    {
      this->Output.Fill(&mesh, scan.Geometry, scan.Start.Pose, scan.Points, scan.Image);
      AddPoses(scan);
      this->AddSurfaceAttributes(scan, scan.Points->GetPointData());
    });
  this->Detection.AddStatus(scan.Geometry, scan.Points, scan.Image);
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
