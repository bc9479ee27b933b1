// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dProcesses.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Bounds the memory that is needed beside the results.
constexpr std::size_t BeamsAtOnce = std::size_t(1) << 20;

/// How many processes have a part of the scene of some kind.
struct Parts
{
  int WithIds = 0;
  int WithoutIds = 0;
  int WithVolume = 0;
};

void Check(const Parts& parts)
{
  if (parts.WithVolume > 0 && parts.WithIds + parts.WithoutIds > 1)
  {
    throw std::runtime_error("The scene has volume cells on several processes, and none of them "
                             "can tell its outer surface from the seams. Extract the surface "
                             "before the scene is spread.");
  }
  if (parts.WithIds > 0 && parts.WithoutIds > 0)
  {
    throw std::runtime_error("The cells of the scene have global ids on " +
      std::to_string(parts.WithIds) + " processes and none on " + std::to_string(parts.WithoutIds) +
      ". Generate them for all, or remove them.");
  }
}

/// What a reduction leaves, for some of the beams.
struct Reduced
{
  void MakeRoom(std::size_t beams)
  {
    this->Nearest.resize(beams);
    this->Hit.resize(beams);
    this->Measured.resize(beams);
  }

  std::vector<double> Nearest;
  std::vector<vtkIdType> Hit;
  std::vector<double> Measured;
};

void Reduce(vtkMultiProcessController* controller, const double* chosenRanges, vtkIdType* cells,
  double* ranges, vtkIdType beams, Reduced& reduced)
{
  controller->AllReduce(chosenRanges, reduced.Nearest.data(), beams, vtkCommunicator::MIN_OP);
  for (vtkIdType i = 0; i < beams; ++i)
  {
    cells[i] = chosenRanges[i] == reduced.Nearest[i] ? cells[i] : lms3dProcesses::NoCell;
  }
  controller->AllReduce(cells, reduced.Hit.data(), beams, vtkCommunicator::MIN_OP);

  // A process whose hit is not the one, or whose hit gives no return, has nothing to say.
  for (vtkIdType i = 0; i < beams; ++i)
  {
    const vtkIdType hit = reduced.Hit[i];
    const bool isMine = hit != lms3dProcesses::NoCell && cells[i] == hit;
    reduced.Measured[i] = isMine && !std::isnan(ranges[i]) ? ranges[i] : Infinity;
    cells[i] = hit;
  }
  controller->AllReduce(reduced.Measured.data(), ranges, beams, vtkCommunicator::MIN_OP);
  std::replace(ranges, ranges + beams, Infinity, std::numeric_limits<double>::quiet_NaN());
}
} // namespace

lms3dProcesses::lms3dProcesses(vtkMultiProcessController* controller)
  : Controller(controller)
  , Count(controller ? controller->GetNumberOfProcesses() : 1)
  , Rank(controller ? controller->GetLocalProcessId() : 0)
{
}

int lms3dProcesses::AllReduceCount(bool mine) const
{
  int count = mine ? 1 : 0;
  if (this->IsParallel())
  {
    const int own = count;
    this->Controller->AllReduce(&own, &count, 1, vtkCommunicator::SUM_OP);
  }
  return count;
}

void lms3dProcesses::ThrowError(const std::string& mine) const
{
  const int candidate = mine.empty() ? this->Count : this->Rank;
  int failed = 0;
  this->Controller->AllReduce(&candidate, &failed, 1, vtkCommunicator::MIN_OP);
  if (failed == this->Count)
  {
    return;
  }
  std::string words = mine;
  vtkIdType length = static_cast<vtkIdType>(words.size());
  this->Controller->Broadcast(&length, 1, failed);
  words.resize(length);
  this->Controller->Broadcast(words.data(), length, failed);
  throw std::runtime_error("Process " + std::to_string(failed) + ": " + words);
}

void lms3dProcesses::Broadcast(lms3dPose& pose, double& time) const
{
  if (!this->IsParallel())
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

std::int64_t lms3dProcesses::GetFirstCellNumber(
  std::int64_t cells, bool hasIds, bool hasVolume) const
{
  const vtkIdType mine[3] = { static_cast<vtkIdType>(cells), hasIds ? 1 : 0, hasVolume ? 1 : 0 };
  std::vector<vtkIdType> all(3 * static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(mine, all.data(), 3);
  std::int64_t first = 0;
  Parts parts;
  for (int rank = 0; rank < this->Count; ++rank)
  {
    const vtkIdType* theirs = all.data() + 3 * static_cast<std::ptrdiff_t>(rank);
    first += rank < this->Rank ? theirs[0] : 0;
    parts.WithIds += theirs[0] > 0 && theirs[1] ? 1 : 0;
    parts.WithoutIds += theirs[0] > 0 && !theirs[1] ? 1 : 0;
    parts.WithVolume += theirs[2] ? 1 : 0;
  }
  Check(parts);
  return parts.WithIds > 0 ? 0 : first;
}

void lms3dProcesses::ReduceToNearest(
  const std::vector<double>& chosenRanges, std::vector<vtkIdType>& cells, double* ranges) const
{
  const std::size_t beams = cells.size();
  Reduced reduced;
  this->RunCollectively([&] { reduced.MakeRoom(std::min(beams, BeamsAtOnce)); });
  for (std::size_t first = 0; first < beams; first += BeamsAtOnce)
  {
    const std::size_t count = std::min(BeamsAtOnce, beams - first);
    Reduce(this->Controller, chosenRanges.data() + first, cells.data() + first, ranges + first,
      static_cast<vtkIdType>(count), reduced);
  }
}
