// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanStart.h"

#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{
constexpr std::size_t NumbersPerPose = sizeof(lms3dTimedPose) / sizeof(double);
static_assert(std::is_trivially_copyable_v<lms3dTimedPose> &&
    sizeof(lms3dTimedPose) == NumbersPerPose * sizeof(double),
  "a timed pose is an array of numbers");

// Whether arrays of the scan, or the light that returns, depend on single beams.
bool DescribesBeams(const lms3dScanSettings& settings)
{
  const lms3dDeviceSettings& device = settings.Device;
  return device.Reflectance.RangeAtTenPercent > 0.0 || device.Arrays.Time || device.Arrays.Poses ||
    lms3dSurfaceArrays(settings).AreAny();
}
} // namespace

void lms3dScanStart::SetDataTime(vtkDataObject* output) const
{
  if (!std::isnan(this->Time))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Time);
  }
}

bool lms3dScanStart::HasPlainBeams(const lms3dDeviceSettings& device) const
{
  return device.Platform.IsCentredAndStepped() && !this->Motion && !device.Footprint.HasWidth();
}

std::unique_ptr<const lms3dMovingBeams> lms3dScanStart::MakeBeams(
  const lms3dScanSettings& settings, const lms3dScanGeometry& geometry) const
{
  const lms3dDeviceSettings& device = settings.Device;
  if (this->HasPlainBeams(device) && !this->HasTurnPoses(device) && !DescribesBeams(settings))
  {
    return nullptr;
  }
  return std::make_unique<const lms3dMovingBeams>(
    geometry, this->Pose, this->Motion.get(), std::isnan(this->Time) ? 0.0 : this->Time);
}

void lms3dScanStart::Broadcast(const lms3dProcesses& processes)
{
  if (!processes.IsParallel())
  {
    return;
  }
  std::vector<lms3dTimedPose> poses = { { this->Time, this->Pose } };
  if (this->Motion)
  {
    poses.insert(poses.end(), this->Motion->GetPoses().begin(), this->Motion->GetPoses().end());
  }
  std::vector<double> numbers(NumbersPerPose * poses.size());
  std::memcpy(numbers.data(), poses.data(), numbers.size() * sizeof(double));
  processes.Broadcast(numbers);
  poses.resize(numbers.size() / NumbersPerPose);
  std::memcpy(static_cast<void*>(poses.data()), numbers.data(), numbers.size() * sizeof(double));
  this->Time = poses.front().Time;
  this->Pose = poses.front().Pose;
  poses.erase(poses.begin());
  this->Motion = poses.empty() ? nullptr : std::make_unique<const lms3dMotion>(std::move(poses));
}
