// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes scans and local maps with the VTK filters.
 */
#ifndef lms3dScanPipeline_h
#define lms3dScanPipeline_h

#include "Scanning/lms3dAlgorithmObservers.h"
#include "Scanning/lms3dSettingsBoard.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <memory>

class lms3dFusedMapMaker;
class vtkAlgorithm;
class vtkLMS3DRangeErrorFilter;
class vtkLMS3DScanFilter;
class vtkLMS3DSurfaceReconstructionFilter;

/// Run() is for one thread at a time. While the scene stays the same, so does its acceleration
/// structure.
class lms3dScanPipeline
{
public:
  /// If the work becomes smaller by more than this factor, memory is returned to the system.
  static constexpr unsigned int ReleaseFactor = 4;

  /// `threads` as NumberOfThreads of the filters: 0 for all cores.
  explicit lms3dScanPipeline(int threads);
  ~lms3dScanPipeline();
  lms3dScanPipeline(const lms3dScanPipeline&) = delete;
  void operator=(const lms3dScanPipeline&) = delete;

  /// Returns the scan `number`, without incarnation and times, which the caller fills in. The
  /// errors of its ranges depend on the number. Calls `isOutdated` meanwhile. Returns null if that
  /// returned true, or Stop() was called, before the scan was complete. Throws std::runtime_error
  /// if a filter fails.
  std::shared_ptr<lms3dSnapshot> Run(
    const lms3dScanSettings& settings, std::uint64_t number, const lms3dStopTest& isOutdated);

  /// Gives the scans of sensors that may lose beams a Status, for maps of many scans. Snapshots
  /// have it only if the device asks for it. Call this before Run().
  void FindLostBeams() { this->FindsLostBeams = true; }

  /// Adds the last scan of Run() to a map of many scans.
  void AddTo(lms3dFusedMapMaker& fusedMap, const lms3dScanSettings& settings, std::uint64_t number);

  /// Aborts the current scan and all later ones. Any thread.
  void Stop() { this->Stopped = true; }

private:
  void Configure(const lms3dScanSettings& settings);
  void ConfigureDevice(const LMS3D::Device& device);
  /// Whether beams that meet a surface may give no return.
  bool MayLoseBeams(const LMS3D::Device& device) const;
  /// Creates or destroys the filter of range errors.
  void PrepareErrors(const LMS3D::Device& device);
  /// Creates or destroys the filter of maps.
  void PrepareMapper(const LMS3D::Configuration& configuration);
  /// Returns true if the current run is to end.
  bool ShouldAbort();
  ///@{
  /// Return false if the work was aborted.
  bool Update(vtkAlgorithm* algorithm, double& seconds) const;
  bool Scan(lms3dSnapshot& snapshot);
  bool AddErrors(lms3dSnapshot& snapshot);
  bool MakeMap(lms3dSnapshot& snapshot);
  ///@}

  vtkNew<vtkLMS3DScanFilter> Scanner;
  /// Null as long as ranges have no errors.
  vtkSmartPointer<vtkLMS3DRangeErrorFilter> Errors;
  /// Null as long as no maps are made.
  vtkSmartPointer<vtkLMS3DSurfaceReconstructionFilter> Mapper;
  bool FindsLostBeams = false;
  /// The number of beams for which the mapper has memory.
  CORBA::ULongLong MapperBeams = 0;
  const int Threads;
  lms3dServedScenePointer Scene;
  std::atomic<bool> Stopped{ false };
  ///@{
  /// The current run: ends it, and whether it was aborted.
  lms3dStopTest IsOutdated;
  std::atomic<bool> Aborted{ false };
  ///@}
};

#endif
