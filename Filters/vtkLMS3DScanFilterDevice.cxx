// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "Device/lms3dDevices.h"

void vtkLMS3DScanFilter::SetDevice(int device)
{
  const lms3dDevice* values = lms3dGetDevice(device);
  if (!values)
  {
    vtkErrorMacro("Device " << device << ": must be from " << IDEAL << " (" << GetDeviceName(IDEAL)
                            << ") to " << LMS291 << " (" << GetDeviceName(LMS291)
                            << "). Nothing changes.");
    return;
  }
  this->SetMaximumRange(values->MaximumRange);
  this->SetBeamDiameter(values->BeamDiameter);
  this->SetBeamDivergence(values->BeamDivergence);
  this->SetBeamSamples(values->BeamSamples);
  this->SetPulseLength(values->PulseLength);
  this->SetRangeAtTenPercent(values->RangeAtTenPercent);
}

int vtkLMS3DScanFilter::GetDevice() const
{
  return lms3dFindDevice(
    [this](const lms3dDevice& device)
    {
      return this->MaximumRange == device.MaximumRange &&
        this->BeamDiameter == device.BeamDiameter &&
        this->BeamDivergence == device.BeamDivergence && this->BeamSamples == device.BeamSamples &&
        this->PulseLength == device.PulseLength &&
        this->RangeAtTenPercent == device.RangeAtTenPercent;
    });
}

int vtkLMS3DScanFilter::GetNumberOfDevices()
{
  return lms3dGetNumberOfDevices();
}

const char* vtkLMS3DScanFilter::GetDeviceName(int device)
{
  return lms3dGetDeviceName(device);
}

double vtkLMS3DScanFilter::GetDeviceValue(int device, const char* property)
{
  return lms3dGetDeviceValue(device, property ? property : "");
}
