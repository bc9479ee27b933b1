// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dFreeBeams.h"

#include "Scan/lms3dBeamStatus.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

std::vector<bool> lms3dFindFreeBeams(vtkPolyData* scan, std::int64_t beams)
{
  vtkDataArray* status = scan->GetFieldData()->GetArray("Status");
  if (!status || status->GetNumberOfComponents() != 1 || status->GetNumberOfTuples() != beams)
  {
    return {};
  }
  const auto isFree = [](auto value)
  {
    return value == static_cast<int>(lms3dBeamStatus::NothingMet) ||
      value == static_cast<int>(lms3dBeamStatus::BeyondRange);
  };
  std::vector<bool> areFree(static_cast<std::size_t>(beams));
  // The array of vtkLMS3DScanFilter, which is read faster than others.
  if (auto* values = vtkUnsignedCharArray::SafeDownCast(status))
  {
    std::transform(values->Begin(), values->End(), areFree.begin(), isFree);
    return areFree;
  }
  for (std::int64_t i = 0; i < beams; ++i)
  {
    areFree[i] = isFree(status->GetTuple1(i));
  }
  return areFree;
}
