// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanStart.h"

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
} // namespace

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
