// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One update of vtkLMS3DRangeErrorFilter, from its input to its outputs.
 */
#ifndef lms3dRangeErrorJob_h
#define lms3dRangeErrorJob_h

#include "Device/lms3dScanGeometry.h"
#include "Device/lms3dScanInput.h"
#include "Pipeline/lms3dMemoryPool.h"
#include "Pipeline/lms3dProgress.h"
#include "Pipeline/lms3dThreads.h"
#include "RangeErrors/lms3dRangeErrors.h"

#include <memory>

class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

/// What one update needs. Everything that a pointer or reference refers to must outlive the update.
struct lms3dRangeErrorJobRequest
{
  /// Must be good.
  const lms3dRangeErrorSettings& Settings;

  int NumberOfThreads;

  /// The processes that work together; null stands for this process alone.
  vtkMultiProcessController* Controller;

  vtkPolyData* Scan;

  /// Output 0, a vtkPolyData, and output 1, a vtkImageData. Both must be empty.
  vtkInformationVector* Outputs;

  /// Called on the calling thread.
  lms3dProgress Progress;
};

/// Keeps from update to update what need not be computed again: tables of angles, threads, memory.
class lms3dRangeErrorJob
{
public:
  /**
   * Fills the outputs. Throws std::runtime_error, with a text for the user, if the scan is bad or
   * memory is short; in all processes if it fails in one. Returns false, in all processes, if
   * `Progress` stopped the work in one of them. The outputs are then incomplete.
   */
  bool Run(const lms3dRangeErrorJobRequest& request);

  /// Returns the grid of the scan, which is valid until the next call, or null if no process has
  /// one. Collective.
  const lms3dScanGeometry* GetGeometry(vtkPolyData* scan, vtkMultiProcessController* controller);

private:
  bool Report(const lms3dRangeErrorJobRequest& request, const lms3dScanInput& scan,
    const lms3dScanGeometry& geometry, double* grid);

  lms3dThreads Threads;
  lms3dMemoryPool Pool;
  std::unique_ptr<lms3dScanGeometry> Geometry;
};

#endif
