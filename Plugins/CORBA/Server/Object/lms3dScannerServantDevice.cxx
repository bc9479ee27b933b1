// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The operations of the scanner's object that are about its device.
#include "Common/lms3dDeviceNames.h"
#include "Object/lms3dReplies.h"
#include "Object/lms3dScannerServant.h"
#include "Object/lms3dSettingsCheck.h"

#include <mutex>
#include <optional>

LMS3D::Device* lms3dScannerServant::getDevice()
{
  return new LMS3D::Device(this->Board.Get().Device);
}

CORBA::ULongLong lms3dScannerServant::setDevice(const LMS3D::Device& newDevice)
{
  this->RequireWritable();
  lms3dCheckDevice(newDevice);
  const std::lock_guard<std::mutex> lock(this->SettingsMutex);
  lms3dCheckRays(this->Board.Get().Configuration, newDevice);
  return this->Board.SetDevice(newDevice);
}

LMS3D::PresetNames* lms3dScannerServant::listPresets()
{
  return lms3dMakePresetNames();
}

LMS3D::Device* lms3dScannerServant::getPreset(const char* name)
{
  const std::optional<LMS3D::Device> device = lms3dFindPreset(name);
  return device ? new LMS3D::Device(*device) : throw LMS3D::NoSuchPreset(name);
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
