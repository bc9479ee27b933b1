// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dSettingsBoard.h"

#include <utility>

lms3dSettingsBoard::lms3dSettingsBoard(lms3dScanSettings settings)
  : Settings(std::move(settings))
{
}

lms3dScanSettings lms3dSettingsBoard::Get() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Settings;
}

std::uint64_t lms3dSettingsBoard::SetPose(const LMS3D::Pose& pose)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Pose = pose;
  return ++this->Settings.Generation;
}

std::uint64_t lms3dSettingsBoard::SetConfiguration(const LMS3D::Configuration& configuration)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Configuration = configuration;
  return ++this->Settings.Generation;
}

std::uint64_t lms3dSettingsBoard::SetScene(lms3dServedScenePointer scene)
{
  // Swapped, so that the previous scene is freed after unlocking.
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Scene.swap(scene);
  return ++this->Settings.Generation;
}
