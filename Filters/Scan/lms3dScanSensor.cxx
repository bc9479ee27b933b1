// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanSensor.h"

#include "Device/lms3dFan.h"

#include <vtkPolyData.h>

#include <utility>

lms3dScanSensor::Angles lms3dScanSensor::GetAngles(const lms3dScanSettings& settings)
{
  return { settings.AlphaRange[0], settings.AlphaRange[1],
    static_cast<double>(settings.AlphaResolution), settings.BetaRange[0], settings.BetaRange[1],
    static_cast<double>(settings.BetaResolution) };
}

bool lms3dScanSensor::HasGeometry(const lms3dScanSettings& settings) const
{
  return this->Geometry && GetAngles(settings) == this->GeometryAngles &&
    settings.Device.Platform == this->Geometry->GetPlatform();
}

// Tables of sines and cosines are computed for new angles only.
const lms3dScanGeometry& lms3dScanSensor::GetGeometry(const lms3dScanSettings& settings)
{
  if (!this->HasGeometry(settings))
  {
    this->Geometry =
      std::make_unique<lms3dScanGeometry>(settings.AlphaRange.data(), settings.AlphaResolution,
        settings.BetaRange.data(), settings.BetaResolution, settings.Device.Platform);
    this->GeometryAngles = GetAngles(settings);
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

lms3dScanStart lms3dScanSensor::GetStart(
  const lms3dScanSettings& settings, vtkPolyData* trajectory, std::optional<double> time)
{
  lms3dScanStart start;
  if (!trajectory)
  {
    start.Pose = lms3dPose::FromOrientation(settings.Position.data(), settings.Orientation.data());
    return start;
  }
  const lms3dTrajectory& poses = this->GetTrajectory(trajectory, settings.Orientation);
  const int step = time ? poses.FindStep(*time) : 0;
  start.Time = poses.GetTimes()[step];
  start.Pose = poses.GetPose(step);
  if (settings.Device.MotionDuringScan)
  {
    const lms3dScanGeometry& geometry = this->GetGeometry(settings);
    const double duration = geometry.GetNumberOfTurns() * lms3dGetFanPeriod(geometry);
    lms3dMotion motion(poses, start.Time, start.Time + duration);
    start.Motion =
      motion.IsAtRest() ? nullptr : std::make_unique<const lms3dMotion>(std::move(motion));
  }
  return start;
}
