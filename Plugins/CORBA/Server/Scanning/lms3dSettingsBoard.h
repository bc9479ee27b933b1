// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the next scan is to be made with.
 */
#ifndef lms3dSettingsBoard_h
#define lms3dSettingsBoard_h

#include "lms3dServedScene.h"

#include <cstdint>
#include <mutex>

struct lms3dScanSettings
{
  LMS3D::Pose Pose;
  LMS3D::Configuration Configuration;
  lms3dServedScenePointer Scene;
  std::uint64_t Generation = 1;
};

/// Clients write on it, the scanner reads it before each scan. Each change makes a new generation.
class lms3dSettingsBoard
{
public:
  explicit lms3dSettingsBoard(lms3dScanSettings settings);

  lms3dScanSettings Get() const;

  ///@{
  /// Returns the new generation.
  std::uint64_t SetPose(const LMS3D::Pose& pose);
  std::uint64_t SetConfiguration(const LMS3D::Configuration& configuration);
  std::uint64_t SetScene(lms3dServedScenePointer scene);
  ///@}

private:
  mutable std::mutex Mutex;
  lms3dScanSettings Settings;
};

#endif
