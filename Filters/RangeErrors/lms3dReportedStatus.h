// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The array Status of a scan whose ranges have errors.
 */
#ifndef lms3dReportedStatus_h
#define lms3dReportedStatus_h

#include "Device/lms3dScanInput.h"

#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

/// The returns that errors removed, and the statuses of all beams.
class lms3dReportedStatus
{
public:
  /// Takes the array Status from the field data of a scan, if it has one value for each of the
  /// `beams` beams of the grid. Returns that are NaN in the grid of reported ranges become
  /// TOO_NEAR. One process without the array does nothing. A null controller stands for this
  /// process alone.
  lms3dReportedStatus(const lms3dScanInput& scan, vtkPolyData* input, const double* grid,
    vtkIdType beams, vtkMultiProcessController* controller);

  /**
   * Returns the statuses of all processes: the input's own array if errors removed no return.
   * Returns null if no process has the array. A scan that has the array gets the returned one in
   * its field data, which is copied. Collective.
   */
  vtkSmartPointer<vtkUnsignedCharArray> Merge(
    vtkMultiProcessController* controller, vtkIdType beams, vtkPolyData* output) const;

private:
  vtkSmartPointer<vtkUnsignedCharArray> Status;

  /// The beams of the returns that errors removed.
  std::vector<vtkIdType> Removed;
};

#endif
