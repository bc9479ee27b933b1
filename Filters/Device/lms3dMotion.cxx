// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dMotion.h"

#include "Device/lms3dTrajectory.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
// A time, a position and three axes.
constexpr std::size_t NumbersPerPose = 13;
} // namespace

lms3dMotion::lms3dMotion(const lms3dTrajectory& trajectory, double first, double last)
{
  const std::vector<double>& times = trajectory.GetTimes();
  const int end =
    std::min(trajectory.FindStep(last) + 1, static_cast<int>(trajectory.GetTimes().size()) - 1);
  for (int step = trajectory.FindStep(first); step <= end; ++step)
  {
    this->Add(times[step], trajectory.GetPose(step));
  }
}

lms3dMotion::lms3dMotion(const std::vector<double>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); i += NumbersPerPose)
  {
    lms3dPose pose;
    std::copy_n(numbers.begin() + i + 1, 3, pose.Position.begin());
    for (int axis = 0; axis < 3; ++axis)
    {
      std::copy_n(numbers.begin() + i + 4 + 3 * axis, 3, pose.Axes[axis].begin());
    }
    this->Add(numbers[i], pose);
  }
}

std::vector<double> lms3dMotion::ToNumbers() const
{
  std::vector<double> numbers;
  for (std::size_t i = 0; i < this->Times.size(); ++i)
  {
    const lms3dPose& pose = this->Poses[i];
    numbers.push_back(this->Times[i]);
    numbers.insert(numbers.end(), pose.Position.begin(), pose.Position.end());
    for (const std::array<double, 3>& axis : pose.Axes)
    {
      numbers.insert(numbers.end(), axis.begin(), axis.end());
    }
  }
  return numbers;
}

void lms3dMotion::Add(double time, const lms3dPose& pose)
{
  if (!this->Poses.empty())
  {
    this->Segments.emplace_back(this->Poses.back(), pose);
  }
  this->Times.push_back(time);
  this->Poses.push_back(pose);
}

bool lms3dMotion::IsAtRest() const
{
  return std::all_of(this->Poses.begin(), this->Poses.end(),
    [this](const lms3dPose& pose) {
      return pose.Position == this->Poses.front().Position && pose.Axes == this->Poses.front().Axes;
    });
}

lms3dPose lms3dMotion::GetPose(double time) const
{
  const auto later = std::upper_bound(this->Times.begin(), this->Times.end(), time);
  if (later == this->Times.begin())
  {
    return this->Poses.front();
  }
  if (later == this->Times.end())
  {
    return this->Poses.back();
  }
  const std::size_t step = later - this->Times.begin() - 1;
  const double start = this->Times[step];
  return this->Segments[step].Interpolate((time - start) / (*later - start));
}
