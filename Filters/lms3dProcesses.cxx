// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dProcesses.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
} // namespace

lms3dProcesses::lms3dProcesses(vtkMultiProcessController* controller)
  : Controller(controller)
  , Count(controller ? controller->GetNumberOfProcesses() : 1)
  , Rank(controller ? controller->GetLocalProcessId() : 0)
{
}

bool lms3dProcesses::AskAny(bool mine) const
{
  int said = mine ? 1 : 0;
  if (this->AreMany())
  {
    const int own = said;
    this->Controller->AllReduce(&own, &said, 1, vtkCommunicator::MAX_OP);
  }
  return said != 0;
}

void lms3dProcesses::ThrowError(const std::string& mine) const
{
  const int candidate = mine.empty() ? this->Count : this->Rank;
  int speaker = 0;
  this->Controller->AllReduce(&candidate, &speaker, 1, vtkCommunicator::MIN_OP);
  if (speaker == this->Count)
  {
    return;
  }
  std::string words = mine;
  vtkIdType length = static_cast<vtkIdType>(words.size());
  this->Controller->Broadcast(&length, 1, speaker);
  words.resize(length);
  this->Controller->Broadcast(words.data(), length, speaker);
  throw std::runtime_error("Process " + std::to_string(speaker) + ": " + words);
}

void lms3dProcesses::Share(lms3dPose& pose, double& time) const
{
  if (!this->AreMany())
  {
    return;
  }
  std::array<double, 13> values;
  std::copy(pose.Position.begin(), pose.Position.end(), values.begin());
  for (int axis = 0; axis < 3; ++axis)
  {
    std::copy(pose.Axes[axis].begin(), pose.Axes[axis].end(), values.begin() + 3 + 3 * axis);
  }
  values[12] = time;
  this->Controller->Broadcast(values.data(), static_cast<vtkIdType>(values.size()), 0);
  std::copy_n(values.begin(), 3, pose.Position.begin());
  for (int axis = 0; axis < 3; ++axis)
  {
    std::copy_n(values.begin() + 3 + 3 * axis, 3, pose.Axes[axis].begin());
  }
  time = values[12];
}

std::int64_t lms3dProcesses::NumberCells(std::int64_t cells, bool hasIds, bool hasVolume) const
{
  if (!this->AreMany())
  {
    return 0;
  }
  const vtkIdType mine[3] = { static_cast<vtkIdType>(cells), hasIds ? 1 : 0, hasVolume ? 1 : 0 };
  std::vector<vtkIdType> all(3 * static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(mine, all.data(), 3);
  std::int64_t first = 0;
  int withIds = 0;
  int without = 0;
  int withVolume = 0;
  for (int rank = 0; rank < this->Count; ++rank)
  {
    const vtkIdType theirs = all[3 * rank];
    first += rank < this->Rank ? theirs : 0;
    withIds += theirs > 0 && all[3 * rank + 1] ? 1 : 0;
    without += theirs > 0 && !all[3 * rank + 1] ? 1 : 0;
    withVolume += all[3 * rank + 2] ? 1 : 0;
  }
  if (withVolume > 0 && withIds + without > 1)
  {
    throw std::runtime_error(
      "The scene has volume cells on several processes, and none of them can "
      "tell its outer surface from the seams. Extract the surface before the "
      "scene is spread.");
  }
  if (withIds > 0 && without > 0)
  {
    throw std::runtime_error("The cells of the scene have global ids on " +
      std::to_string(withIds) + " processes and none on " + std::to_string(without) +
      ". Generate them for all, or remove them.");
  }
  return withIds > 0 ? 0 : first;
}

void lms3dProcesses::TakeNearest(
  const std::vector<double>& chosenRanges, std::vector<vtkIdType>& cells, double* ranges) const
{
  const vtkIdType beams = static_cast<vtkIdType>(cells.size());
  std::vector<double> nearest(beams);
  this->Controller->AllReduce(chosenRanges.data(), nearest.data(), beams, vtkCommunicator::MIN_OP);
  for (vtkIdType i = 0; i < beams; ++i)
  {
    cells[i] = chosenRanges[i] == nearest[i] ? cells[i] : NoCell;
  }
  std::vector<vtkIdType> hit(beams);
  this->Controller->AllReduce(cells.data(), hit.data(), beams, vtkCommunicator::MIN_OP);

  // A process whose hit is not the one, or whose hit gives no return, has nothing to say.
  std::vector<double> said(beams);
  for (vtkIdType i = 0; i < beams; ++i)
  {
    const bool isMine = hit[i] != NoCell && cells[i] == hit[i];
    said[i] = isMine && !std::isnan(ranges[i]) ? ranges[i] : Infinity;
  }
  this->Controller->AllReduce(said.data(), ranges, beams, vtkCommunicator::MIN_OP);
  cells = std::move(hit);
  for (vtkIdType i = 0; i < beams; ++i)
  {
    ranges[i] = ranges[i] == Infinity ? NAN : ranges[i];
  }
}
