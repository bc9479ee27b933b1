// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dProcesses.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>
#include <vtkMultiProcessStream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Limits the memory that is needed in addition to the results.
constexpr std::size_t BeamsAtOnce = std::size_t(1) << 20;

/// The number of processes that have cells of a kind.
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
    throw std::runtime_error(
      "The scene has volume cells on several processes, so no process can distinguish its outer "
      "surface from the seams. Extract the surface before the scene is distributed.");
  }
  if (parts.WithIds > 0 && parts.WithoutIds > 0)
  {
    throw std::runtime_error("The cells of the scene have global ids on " +
      std::to_string(parts.WithIds) + " processes and none on " + std::to_string(parts.WithoutIds) +
      ". Generate global ids for all cells, or remove them.");
  }
}

void CountKinds(const lms3dScenePart& part, Parts& parts)
{
  const bool hasCells = part.NumberOfCells > 0;
  parts.WithIds += hasCells && part.HasGlobalIds ? 1 : 0;
  parts.WithoutIds += hasCells && !part.HasGlobalIds ? 1 : 0;
  parts.WithVolume += part.HasVolume ? 1 : 0;
}

void Add(const lms3dScenePart& part, lms3dScenePart& whole)
{
  whole.NumberOfCells += part.NumberOfCells;
  whole.HiddenCells += part.HiddenCells;
  whole.HasVolume = whole.HasVolume || part.HasVolume;
  if (part.HasGlobalIds)
  {
    const bool isFirst = !whole.HasGlobalIds;
    whole.MinimumGlobalId =
      isFirst ? part.MinimumGlobalId : std::min(whole.MinimumGlobalId, part.MinimumGlobalId);
    whole.MaximumGlobalId =
      isFirst ? part.MaximumGlobalId : std::max(whole.MaximumGlobalId, part.MaximumGlobalId);
    whole.HasGlobalIds = true;
  }
}

using PartMessage = std::array<vtkIdType, 6>;

PartMessage ToMessage(const lms3dScenePart& part)
{
  const auto toId = [](std::int64_t value) { return static_cast<vtkIdType>(value); };
  return { toId(part.NumberOfCells), toId(part.HiddenCells), part.HasGlobalIds ? 1 : 0,
    toId(part.MinimumGlobalId), toId(part.MaximumGlobalId), part.HasVolume ? 1 : 0 };
}

lms3dScenePart FromMessage(const std::vector<vtkIdType>& messages, int rank)
{
  const vtkIdType* message = messages.data() + std::tuple_size_v<PartMessage> * rank;
  return { message[0], message[1], message[2] != 0, message[3], message[4], message[5] != 0 };
}

/// The results of the three reductions, for some of the beams.
struct Reduced
{
  void Resize(std::size_t beams)
  {
    this->Nearest.resize(beams);
    this->Hit.resize(beams);
    this->Measured.resize(beams);
  }

  std::vector<double> Nearest;
  std::vector<vtkIdType> Hit;
  std::vector<double> Measured;
};

void Reduce(vtkMultiProcessController* controller, const double* nearestRanges, vtkIdType* cells,
  double* ranges, vtkIdType beams, Reduced& reduced)
{
  controller->AllReduce(nearestRanges, reduced.Nearest.data(), beams, vtkCommunicator::MIN_OP);
  for (vtkIdType i = 0; i < beams; ++i)
  {
    cells[i] = nearestRanges[i] == reduced.Nearest[i] ? cells[i] : lms3dProcesses::NoCell;
  }
  controller->AllReduce(cells, reduced.Hit.data(), beams, vtkCommunicator::MIN_OP);

  // Infinity stands for a hit that is not the nearest, or that gives no return.
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

void lms3dProcesses::ThrowFirstError(const std::string& mine) const
{
  const int candidate = mine.empty() ? this->Count : this->Rank;
  int failed = 0;
  this->Controller->AllReduce(&candidate, &failed, 1, vtkCommunicator::MIN_OP);
  if (failed == this->Count)
  {
    return;
  }
  std::string error = mine;
  vtkIdType length = static_cast<vtkIdType>(error.size());
  this->Controller->Broadcast(&length, 1, failed);
  error.resize(length);
  this->Controller->Broadcast(error.data(), length, failed);
  throw std::runtime_error("Process " + std::to_string(failed) + ": " + error);
}

void lms3dProcesses::Broadcast(std::vector<double>& numbers) const
{
  if (this->IsParallel())
  {
    vtkIdType count = static_cast<vtkIdType>(numbers.size());
    this->Controller->Broadcast(&count, 1, 0);
    this->RunCollectively([&] { numbers.resize(static_cast<std::size_t>(count)); });
    this->Controller->Broadcast(numbers.data(), count, 0);
  }
}

void lms3dProcesses::Broadcast(vtkMultiProcessStream& stream) const
{
  if (this->IsParallel())
  {
    this->Controller->Broadcast(stream, 0);
  }
}

lms3dProcesses::Cells lms3dProcesses::GatherCells(const lms3dScenePart& mine) const
{
  if (!this->IsParallel())
  {
    return { mine, 0 };
  }
  const PartMessage message = ToMessage(mine);
  std::vector<vtkIdType> messages(message.size() * static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(
    message.data(), messages.data(), static_cast<vtkIdType>(message.size()));
  Cells cells;
  Parts parts;
  for (int rank = 0; rank < this->Count; ++rank)
  {
    const lms3dScenePart part = FromMessage(messages, rank);
    cells.First += rank < this->Rank ? part.NumberOfCells : 0;
    CountKinds(part, parts);
    Add(part, cells.Whole);
  }
  Check(parts);
  cells.First = parts.WithIds > 0 ? 0 : cells.First;
  return cells;
}

std::vector<vtkSmartPointer<vtkDataObject>> lms3dProcesses::GatherToFirst(vtkDataObject* mine) const
{
  std::vector<vtkSmartPointer<vtkDataObject>> objects(1, mine);
  if (this->IsParallel())
  {
    const bool isDone = this->Controller->Gather(mine, objects, 0) != 0;
    this->RunCollectively(
      [isDone]
      {
        if (!isDone)
        {
          throw std::runtime_error("The processes cannot exchange their surface attributes.");
        }
      });
  }
  return objects;
}

void lms3dProcesses::ReduceToNearest(
  const std::vector<double>& nearestRanges, std::vector<vtkIdType>& cells, double* ranges) const
{
  const std::size_t beams = cells.size();
  Reduced reduced;
  this->RunCollectively([&] { reduced.Resize(std::min(beams, BeamsAtOnce)); });
  for (std::size_t first = 0; first < beams; first += BeamsAtOnce)
  {
    const std::size_t count = std::min(BeamsAtOnce, beams - first);
    Reduce(this->Controller, nearestRanges.data() + first, cells.data() + first, ranges + first,
      static_cast<vtkIdType>(count), reduced);
  }
}
