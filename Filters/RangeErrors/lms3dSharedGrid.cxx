// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dSharedGrid.h"

#include "Scan/lms3dProcesses.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Limits the memory that is needed in addition to the grid.
constexpr std::size_t BeamsAtOnce = std::size_t(1) << 20;

void Broadcast(vtkMultiProcessController* controller, int root, std::vector<double>& numbers)
{
  vtkIdType count = static_cast<vtkIdType>(numbers.size());
  controller->Broadcast(&count, 1, root);
  numbers.resize(static_cast<std::size_t>(count));
  controller->Broadcast(numbers.data(), count, root);
}

void Broadcast(vtkMultiProcessController* controller, int root, lms3dPlatform& platform)
{
  const auto& [x, y, z] = platform.AxisOffset;
  std::vector<double> numbers = { static_cast<double>(platform.Mounting), x, y, z,
    platform.TurnRate };
  Broadcast(controller, root, numbers);
  platform = { static_cast<lms3dMounting>(static_cast<int>(numbers[0])),
    { numbers[1], numbers[2], numbers[3] }, numbers[4] };
}
} // namespace

lms3dGridAngles lms3dShareAngles(const lms3dGridAngles& mine, vtkMultiProcessController* controller)
{
  const lms3dProcesses processes(controller);
  if (!processes.IsParallel())
  {
    return mine;
  }
  const int candidate = mine.Alpha.empty() ? processes.GetCount() : processes.GetRank();
  int root = 0;
  controller->AllReduce(&candidate, &root, 1, vtkCommunicator::MIN_OP);
  if (root == processes.GetCount())
  {
    return {};
  }
  lms3dGridAngles angles = mine;
  Broadcast(controller, root, angles.Alpha);
  Broadcast(controller, root, angles.Beta);
  Broadcast(controller, root, angles.Platform);
  return angles;
}

void lms3dMergeGrids(vtkMultiProcessController* controller, std::size_t beams, double* grid)
{
  if (!lms3dProcesses(controller).IsParallel())
  {
    return;
  }
  std::vector<double> mine;
  for (std::size_t first = 0; first < beams; first += BeamsAtOnce)
  {
    double* ranges = grid + first;
    const std::size_t count = std::min(BeamsAtOnce, beams - first);
    mine.assign(ranges, ranges + count);
    const auto isMissing = [](double range) { return std::isnan(range); };
    std::replace_if(mine.begin(), mine.end(), isMissing, Infinity);
    controller->AllReduce(
      mine.data(), ranges, static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
    std::replace(ranges, ranges + count, Infinity, std::numeric_limits<double>::quiet_NaN());
  }
}
