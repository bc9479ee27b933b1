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

std::uint64_t lms3dSettingsBoard::GetGeneration() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Settings.Generation;
}

void lms3dSettingsBoard::WaitForChange(std::uint64_t generation, Clock::time_point deadline) const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait_until(lock, deadline,
    [this, generation] { return this->Stopped || this->Settings.Generation > generation; });
}

void lms3dSettingsBoard::Stop()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Stopped = true;
  this->Changed.notify_all();
}

std::uint64_t lms3dSettingsBoard::SetPose(const LMS3D::Pose& pose)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Pose = pose;
  return this->Advance();
}

std::uint64_t lms3dSettingsBoard::SetConfiguration(const LMS3D::Configuration& configuration)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Configuration = configuration;
  return this->AdvanceFusedMap();
}

std::uint64_t lms3dSettingsBoard::SetDevice(
  const LMS3D::Device& device, const LMS3D::Configuration& configuration)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Device = device;
  this->Settings.Configuration = configuration;
  return this->AdvanceFusedMap();
}

std::uint64_t lms3dSettingsBoard::SetScene(lms3dServedScenePointer scene)
{
  // Swapped, so that the previous scene is freed after unlocking.
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Settings.Scene.swap(scene);
  return this->AdvanceFusedMap();
}

std::uint64_t lms3dSettingsBoard::BeginFusedMap()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->AdvanceFusedMap();
}

std::uint64_t lms3dSettingsBoard::AdvanceFusedMap()
{
  ++this->Settings.FusedMap;
  return this->Advance();
}

std::uint64_t lms3dSettingsBoard::Advance()
{
  this->Changed.notify_all();
  return ++this->Settings.Generation;
}
