// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins the local maps of the server's poses to one map that grows.
 */
#ifndef lms3dFusedMapMaker_h
#define lms3dFusedMapMaker_h

#include "Scanning/lms3dFusedMapStore.h"
#include "Scanning/lms3dSettingsBoard.h"

#include <vtkNew.h>

#include <atomic>
#include <chrono>
#include <cstdint>

class vtkLMS3DMapFusion;
class vtkPolyData;

struct lms3dFusedMapOptions
{
  /// The error bound of the map, metres, above 0.
  double MaximumError = 0.01;
  /// As NumberOfThreads of the filters: 0 for all cores.
  int Threads = 0;
  /// The memory of a map, bytes, as estimated from its scans, its regions and its surface.
  double MaximumBytes = 1e9;
};

/// Add() is for one thread.
class lms3dFusedMapMaker
{
public:
  /// `incarnation` is the start of the server, nanoseconds since 1970. Numbers of states begin
  /// after it, so that a state of an earlier server is not taken for one of this server. The store
  /// must outlive this object.
  lms3dFusedMapMaker(
    const lms3dFusedMapOptions& options, std::uint64_t incarnation, lms3dFusedMapStore& store);
  ~lms3dFusedMapMaker();
  lms3dFusedMapMaker(const lms3dFusedMapMaker&) = delete;
  void operator=(const lms3dFusedMapMaker&) = delete;

  /**
   * Adds the scan `number`, unless one with the same generation was added, and publishes the new
   * state. Begins a new map if the settings ask for one. If the scan cannot be added, the map
   * stays, and the store has the problem. `map` is null if the settings make no local map.
   */
  void Add(
    const lms3dScanSettings& settings, std::uint64_t number, vtkPolyData* map, vtkPolyData* scan);

  /// Aborts the current call of Add() and all later ones. Any thread.
  void Stop() { this->Stopped = true; }

private:
  void BeginMap(const lms3dScanSettings& settings);
  /// Why the scan cannot be added. Empty if it can.
  std::string FindProblem(const lms3dScanSettings& settings, vtkPolyData* map) const;
  /// Whether points at a sensor there would be rounded too coarsely.
  bool IsTooFar(const LMS3D::Vector3& position) const;
  /// An estimate of the memory, if all triangles of a local map are new regions.
  double EstimateBytes(const lms3dScanSettings& settings, vtkPolyData* map) const;
  /// Returns the problem. Empty if the scan was added.
  std::string Fuse(vtkPolyData* map, vtkPolyData* scan);
  /// Publishes the state with the scan `number`, which was added from `start` on.
  void PublishScan(const lms3dScanSettings& settings, std::uint64_t number,
    std::chrono::steady_clock::time_point start);
  /// Publishes the next state, with the regions that differ from the newest one.
  void Publish(const lms3dFusedRegions& changes);
  void SetProblem(const std::string& problem);

  const lms3dFusedMapOptions Options;
  lms3dFusedMapStore& Store;
  const vtkNew<vtkLMS3DMapFusion> Fusion;
  std::atomic<bool> Stopped{ false };
  /// The newest state, also before it is published.
  lms3dFusedMapState State;
  ///@{
  /// The settings of the map, and of the last scan that was considered; 0 before the first.
  std::uint64_t MapSettings = 0;
  std::uint64_t Generation = 0;
  ///@}
  std::uint64_t Beams = 0;
  /// The revision of the filter whose regions all states have. A scan that failed half-way may have
  /// changed regions since.
  int PublishedRevision = -1;
};

#endif
