// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes scans and their maps with the VTK filters.
 */
#ifndef lms3dScanPipeline_h
#define lms3dScanPipeline_h

#include "lms3dSettingsBoard.h"
#include "lms3dSnapshot.h"

#include <vtkNew.h>

#include <atomic>
#include <memory>

class vtkAlgorithm;
class vtkLMS3DScanFilter;
class vtkLMS3DSurfaceReconstructionFilter;

/// For one thread at a time. The acceleration structure of a scene is kept from scan to scan.
class lms3dScanPipeline
{
public:
  /// `threads` as NumberOfThreads of the filters.
  explicit lms3dScanPipeline(int threads);
  ~lms3dScanPipeline();
  lms3dScanPipeline(const lms3dScanPipeline&) = delete;
  void operator=(const lms3dScanPipeline&) = delete;

  /// Header and numbers of a scan, without its number, incarnation and times; null where Stop() ended
  /// it. Throws std::runtime_error where a filter fails.
  std::shared_ptr<lms3dSnapshot> Run(const lms3dScanSettings& settings);

  /// From any thread: ends the scan that is being made.
  void Stop() { this->Stopped = true; }

private:
  void Configure(const lms3dScanSettings& settings);
  ///@{
  /// False where Stop() ended it.
  bool Update(vtkAlgorithm* algorithm, double& seconds) const;
  bool Scan(lms3dSnapshot& snapshot);
  bool MakeMap(lms3dSnapshot& snapshot);
  ///@}

  vtkNew<vtkLMS3DScanFilter> Scanner;
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> Mapper;
  lms3dServedScenePointer Scene;
  std::atomic<bool> Stopped{ false };
};

#endif
