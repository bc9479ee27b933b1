// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dBeamStatus.h"

#include "Pipeline/lms3dArray.h"
#include "Scan/lms3dProcesses.h"

#include <vtkCommunicator.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
const char* const StatusName = "Status";

// The smallest part of a loop over beams that a thread takes.
constexpr std::size_t MinimumGrainSize = 4096;

// Limits the memory that is needed in addition to the results.
constexpr std::size_t ValuesAtOnce = std::size_t(1) << 20;

lms3dBeamStatus GetStatus(const lms3dBeamOutcomes& outcomes, std::size_t beam)
{
  if (outcomes.IsWeak && outcomes.IsWeak[beam] != 0)
  {
    return lms3dBeamStatus::TooWeak;
  }
  if (!std::isnan(outcomes.Ranges[beam]))
  {
    return lms3dBeamStatus::Return;
  }
  if (!outcomes.Unlimited || std::isnan(outcomes.Unlimited[beam]))
  {
    return lms3dBeamStatus::NothingMet;
  }
  return outcomes.Unlimited[beam] < outcomes.Minimum ? lms3dBeamStatus::TooNear
                                                     : lms3dBeamStatus::BeyondRange;
}
} // namespace

vtkSmartPointer<vtkUnsignedCharArray> lms3dMakeStatus(
  const lms3dBeamOutcomes& outcomes, std::size_t beams)
{
  auto status = lms3dMakeArray<vtkUnsignedCharArray>(StatusName, beams);
  unsigned char* values = status->GetPointer(0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, beams, MinimumGrainSize),
    [&outcomes, values](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t beam = range.begin(); beam < range.end(); ++beam)
      {
        values[beam] = static_cast<unsigned char>(GetStatus(outcomes, beam));
      }
    });
  return status;
}

// ParaView would also hide the array of the image if both were one object.
void lms3dAddStatus(vtkUnsignedCharArray* status, vtkFieldData* data)
{
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->ShallowCopy(status);
  hidden->SetName(StatusName);
  lms3dAddHiddenArray(hidden, data);
}

void lms3dAddStatus(vtkUnsignedCharArray* status, int beams, vtkImageData* image)
{
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (image->GetNumberOfPoints() == status->GetNumberOfValues())
  {
    vtkNew<vtkUnsignedCharArray> whole;
    whole->ShallowCopy(status);
    whole->SetName(StatusName);
    image->GetPointData()->AddArray(whole);
    return;
  }
  const int* extent = image->GetExtent();
  const auto part = lms3dMakeArray<vtkUnsignedCharArray>(
    StatusName, static_cast<std::size_t>(image->GetNumberOfPoints()));
  unsigned char* out = part->GetPointer(0);
  for (int turn = extent[2]; turn <= extent[3]; ++turn)
  {
    const unsigned char* row = status->GetPointer(static_cast<vtkIdType>(turn) * beams);
    out = std::copy(row + extent[0], row + extent[1] + 1, out);
  }
  image->GetPointData()->AddArray(part);
}

void lms3dReduceToLargest(
  vtkMultiProcessController* controller, unsigned char* values, std::size_t count)
{
  const lms3dProcesses processes(controller);
  if (!processes.IsParallel())
  {
    return;
  }
  std::vector<unsigned char> mine;
  processes.RunCollectively([&] { mine.resize(std::min(count, ValuesAtOnce)); });
  for (std::size_t first = 0; first < count; first += ValuesAtOnce)
  {
    const std::size_t size = std::min(ValuesAtOnce, count - first);
    std::copy_n(values + first, size, mine.begin());
    controller->AllReduce(
      mine.data(), values + first, static_cast<vtkIdType>(size), vtkCommunicator::MAX_OP);
  }
}
