// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanSensor.h"

#include "Device/lms3dFan.h"

#include <vtkInformation.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <utility>

// Tables of sines and cosines are computed for new angles only.
const lms3dScanGeometry& lms3dScanSensor::GetGeometry(const lms3dScanSettings& settings)
{
  const Angles angles = { settings.AlphaRange[0], settings.AlphaRange[1],
    static_cast<double>(settings.AlphaResolution), settings.BetaRange[0], settings.BetaRange[1],
    static_cast<double>(settings.BetaResolution) };
  const lms3dPlatform& platform = settings.Device.Platform;
  if (!this->Geometry || angles != this->GeometryAngles ||
    !(platform == this->Geometry->GetPlatform()))
  {
    this->Geometry = std::make_unique<lms3dScanGeometry>(settings.AlphaRange.data(),
      settings.AlphaResolution, settings.BetaRange.data(), settings.BetaResolution, platform);
    this->GeometryAngles = angles;
  }
  return *this->Geometry;
}

const lms3dTrajectory& lms3dScanSensor::GetTrajectory(
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

lms3dPose lms3dScanSensor::GetPose(
  const lms3dScanSettings& settings, vtkPolyData* trajectory, vtkInformation& output, double& time)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!trajectory)
  {
    time = NAN;
    return lms3dPose::FromOrientation(settings.Position.data(), settings.Orientation.data());
  }
  const lms3dTrajectory& poses = this->GetTrajectory(trajectory, settings.Orientation);
  const int step = output.Has(Pipeline::UPDATE_TIME_STEP())
    ? poses.FindStep(output.Get(Pipeline::UPDATE_TIME_STEP()))
    : 0;
  time = poses.GetTimes()[step];
  return poses.GetPose(step);
}

std::unique_ptr<lms3dMotion> lms3dScanSensor::GetMotion(
  const lms3dScanSettings& settings, vtkPolyData* trajectory, double time)
{
  if (!trajectory || !settings.Device.MotionDuringScan)
  {
    return nullptr;
  }
  const lms3dScanGeometry& geometry = this->GetGeometry(settings);
  const double end = time + geometry.GetNumberOfTurns() * lms3dGetFanPeriod(geometry);
  auto motion =
    std::make_unique<lms3dMotion>(this->GetTrajectory(trajectory, settings.Orientation), time, end);
  return motion->IsAtRest() ? nullptr : std::move(motion);
}
