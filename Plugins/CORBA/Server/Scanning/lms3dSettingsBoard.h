// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The settings of the next scan.
 */
#ifndef lms3dSettingsBoard_h
#define lms3dSettingsBoard_h

#include "Common/lms3dDeviceNames.h"
#include "Scanning/lms3dServedScene.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

struct lms3dScanSettings
{
  /// Metres and degrees, as LMS3DScanner.idl defines them.
  LMS3D::Pose Pose;
  LMS3D::Configuration Configuration;
  LMS3D::Device Device = lms3dGetIdealDevice();
  /// Never null.
  lms3dServedScenePointer Scene;
  /// Counts the changes of settings, from 1.
  std::uint64_t Generation = 1;
  /// Counts the changes that begin a new fused map, from 1: all except a new pose.
  std::uint64_t FusedMap = 1;
};

/// Clients write the settings, and the scanner reads them before each scan. Each change makes a new
/// generation. All methods may be called from any thread.
class lms3dSettingsBoard
{
public:
  using Clock = std::chrono::steady_clock;

  explicit lms3dSettingsBoard(lms3dScanSettings settings);

  lms3dScanSettings Get() const;
  std::uint64_t GetGeneration() const;

  /// Waits until the generation is above `generation`. Returns at the deadline at the latest, and
  /// at once after Stop().
  void WaitForChange(std::uint64_t generation, Clock::time_point deadline) const;

  /// Ends all current and later calls of WaitForChange().
  void Stop();

  ///@{
  /// Replaces a setting, or two at once, and returns the new generation. The settings must be
  /// valid.
  std::uint64_t SetPose(const LMS3D::Pose& pose);
  std::uint64_t SetConfiguration(const LMS3D::Configuration& configuration);
  std::uint64_t SetDevice(const LMS3D::Device& device, const LMS3D::Configuration& configuration);
  std::uint64_t SetScene(lms3dServedScenePointer scene);
  ///@}

  /// Begins a new fused map with the next scan, and returns the new generation.
  std::uint64_t BeginFusedMap();

private:
  ///@{
  /// The caller has locked the mutex.
  std::uint64_t Advance();
  std::uint64_t AdvanceFusedMap();
  ///@}

  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  bool Stopped = false;
  lms3dScanSettings Settings;
};

#endif
