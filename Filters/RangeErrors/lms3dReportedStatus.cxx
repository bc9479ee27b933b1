// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dReportedStatus.h"

#include "Scan/lms3dBeamStatus.h"
#include "Scan/lms3dProcesses.h"

#include <vtkFieldData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
const char* const StatusName = "Status";

// Another object may share the field data.
void ReplaceStatus(vtkUnsignedCharArray* status, vtkPolyData* output)
{
  vtkNew<vtkFieldData> fieldData;
  fieldData->ShallowCopy(output->GetFieldData());
  lms3dAddStatus(status, fieldData);
  output->SetFieldData(fieldData);
}
} // namespace

lms3dReportedStatus::lms3dReportedStatus(const lms3dScanInput& scan, vtkPolyData* input,
  const double* grid, vtkIdType beams, vtkMultiProcessController* controller)
{
  auto* status =
    vtkUnsignedCharArray::SafeDownCast(input->GetFieldData()->GetAbstractArray(StatusName));
  if (status && status->GetNumberOfComponents() == 1 && status->GetNumberOfTuples() == beams)
  {
    this->Status = status;
  }
  const bool isNeeded = this->Status || lms3dProcesses(controller).IsParallel();
  const vtkIdType count = isNeeded ? scan.GetNumberOfReturns() : 0;
  const int* ids = count > 0 ? scan.GetBeamIds() : nullptr;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (std::isnan(grid[ids[i]]))
    {
      this->Removed.push_back(ids[i]);
    }
  }
}

vtkSmartPointer<vtkUnsignedCharArray> lms3dReportedStatus::Merge(
  vtkMultiProcessController* controller, vtkIdType beams, vtkPolyData* output) const
{
  const lms3dProcesses processes(controller);
  if (!processes.AnyOf(this->Status != nullptr))
  {
    return nullptr;
  }
  const bool isChanged = processes.AnyOf(!this->Removed.empty());
  if (!isChanged && !processes.IsParallel())
  {
    return this->Status;
  }
  vtkSmartPointer<vtkUnsignedCharArray> merged;
  processes.RunCollectively(
    [&]
    {
      merged = vtkSmartPointer<vtkUnsignedCharArray>::New();
      merged->SetName(StatusName);
      merged->SetNumberOfValues(beams);
      merged->FillValue(static_cast<unsigned char>(lms3dBeamStatus::Return));
      if (this->Status)
      {
        std::copy_n(this->Status->GetPointer(0), beams, merged->GetPointer(0));
      }
      for (vtkIdType beam : this->Removed)
      {
        merged->SetValue(beam, static_cast<unsigned char>(lms3dBeamStatus::TooNear));
      }
    });
  lms3dReduceToLargest(controller, merged->GetPointer(0), static_cast<std::size_t>(beams));
  if (isChanged && this->Status)
  {
    ReplaceStatus(merged, output);
  }
  return merged;
}
