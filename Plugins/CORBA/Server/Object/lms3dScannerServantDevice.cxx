// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The operations of the scanner's object that are about its device.
#include "Common/lms3dDeviceNames.h"
#include "Object/lms3dReplies.h"
#include "Object/lms3dScannerServant.h"
#include "Object/lms3dSettingsCheck.h"

#include <mutex>
#include <optional>

namespace
{
LMS3D::Preset FindPreset(const char* name)
{
  const std::optional<LMS3D::Preset> preset = lms3dFindPreset(name);
  return preset ? *preset : throw LMS3D::NoSuchPreset(name);
}
} // namespace

LMS3D::Device* lms3dScannerServant::getDevice()
{
  return new LMS3D::Device(this->Board.Get().Device);
}

CORBA::ULongLong lms3dScannerServant::setDevice(const LMS3D::Device& newDevice)
{
  this->RequireWritable();
  lms3dCheckDevice(newDevice);
  const std::lock_guard<std::mutex> lock(this->SettingsMutex);
  const LMS3D::Configuration configuration = this->Board.Get().Configuration;
  lms3dCheckRays(configuration, newDevice);
  return this->Board.SetDevice(newDevice, configuration);
}

LMS3D::PresetNames* lms3dScannerServant::listPresets()
{
  return lms3dMakePresetNames();
}

LMS3D::Preset* lms3dScannerServant::getPreset(const char* name)
{
  return new LMS3D::Preset(FindPreset(name));
}

CORBA::ULongLong lms3dScannerServant::selectPreset(const char* name)
{
  this->RequireWritable();
  const LMS3D::Preset preset = FindPreset(name);
  const std::lock_guard<std::mutex> lock(this->SettingsMutex);
  lms3dScanSettings settings = this->Board.Get();
  lms3dSetPreset(preset, settings.Device);
  settings.Configuration.maximumRange = preset.maximumRange;
  lms3dCheckConfiguration(settings.Configuration);
  lms3dCheckRays(settings.Configuration, settings.Device);
  return this->Board.SetDevice(settings.Device, settings.Configuration);
}

LMS3D::Device* lms3dScannerServant::getScanDevice(CORBA::ULongLong number)
{
  return new LMS3D::Device(this->Find(number)->Device);
}

LMS3D::BeamStatuses* lms3dScannerServant::getBeamStatuses(
  CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakePart<LMS3D::BeamStatuses>(this->Find(number)->Statuses, 1, first, count);
}
