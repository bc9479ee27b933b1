// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dMotion.h"

#include "Device/lms3dTrajectory.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace
{
std::vector<lms3dTimedPose> GetPart(const lms3dTrajectory& trajectory, double first, double last)
{
  const std::vector<double>& times = trajectory.GetTimes();
  const int end = std::min(trajectory.FindStep(last) + 1, static_cast<int>(times.size()) - 1);
  std::vector<lms3dTimedPose> poses;
  for (int step = trajectory.FindStep(first); step <= end; ++step)
  {
    poses.push_back({ times[step], trajectory.GetPose(step) });
  }
  return poses;
}
} // namespace

lms3dMotion::lms3dMotion(const lms3dTrajectory& trajectory, double first, double last)
  : lms3dMotion(GetPart(trajectory, first, last))
{
}

lms3dMotion::lms3dMotion(std::vector<lms3dTimedPose> poses)
  : Poses(std::move(poses))
{
  for (std::size_t i = 1; i < this->Poses.size(); ++i)
  {
    this->Segments.emplace_back(this->Poses[i - 1].Pose, this->Poses[i].Pose);
  }
}

bool lms3dMotion::IsAtRest() const
{
  const lms3dPose& first = this->Poses.front().Pose;
  return std::all_of(this->Poses.begin(), this->Poses.end(),
    [&first](const lms3dTimedPose& pose)
    { return pose.Pose.Position == first.Position && pose.Pose.Axes == first.Axes; });
}

lms3dPose lms3dMotion::GetPose(double time) const
{
  const auto later = std::upper_bound(this->Poses.begin(), this->Poses.end(), time,
    [](double t, const lms3dTimedPose& pose) { return t < pose.Time; });
  if (later == this->Poses.begin())
  {
    return this->Poses.front().Pose;
  }
  if (later == this->Poses.end())
  {
    return this->Poses.back().Pose;
  }
  const auto earlier = later - 1;
  const double share = (time - earlier->Time) / (later->Time - earlier->Time);
  return this->Segments[earlier - this->Poses.begin()].Interpolate(share);
}
