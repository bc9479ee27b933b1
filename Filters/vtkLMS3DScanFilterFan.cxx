// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DScanFilter.h"

#include "vtkLMS3DScanFilterInternals.h"

#include "Pipeline/lms3dFailure.h"

#include <vtkDoubleArray.h>
#include <vtkMultiProcessController.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

bool vtkLMS3DScanFilter::CastFan(
  double beta, double time, vtkDoubleArray* ranges, vtkUnsignedCharArray* status)
{
  lms3dScanSettings settings = Internals::GetSettings(this);
  settings.BetaRange = { beta, beta };
  settings.BetaResolution = 1;
  settings.SurfaceAttributes = false;
  settings.Device.Arrays = {};
  settings.Device.Arrays.Status = status != nullptr;
  std::string error = Internals::FindFanError(this, beta, ranges);
  error = error.empty() ? lms3dFindSettingsError(settings) : error;
  if (error.empty())
  {
    const auto warn = [this](const std::string& text) { vtkWarningMacro(<< text); };
    const lms3dScanJobRequest fan = { settings, nullptr, this->GetInputDataObject(0, 0),
      vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0)), time, nullptr,
      [](double) { return true; }, warn };
    error = lms3dRunAndGetError([&] { this->Internal->Job.CastRanges(fan, ranges, status); },
      "There is not enough memory for the fan. Simplify the scene, or lower AlphaResolution.");
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

// Returns a text for the user if no fan can be cast, otherwise nothing.
std::string vtkLMS3DScanFilter::Internals::FindFanError(
  vtkLMS3DScanFilter* self, double beta, vtkDoubleArray* ranges)
{
  if (!ranges)
  {
    return "There is no array for the ranges. Pass a vtkDoubleArray.";
  }
  if (!std::isfinite(beta))
  {
    return "The platform angle is not finite. Pass degrees.";
  }
  if (self->GetController() && self->GetController()->GetNumberOfProcesses() > 1)
  {
    return "One process alone can cast a fan: each of several has a part of the scene. Update the "
           "filter instead.";
  }
  if (!self->GetInputDataObject(0, 0))
  {
    return "There is no scene. Connect one.";
  }
  if (self->GetNumberOfInputConnections(1) > 0 &&
    !vtkPolyData::SafeDownCast(self->GetInputDataObject(1, 0)))
  {
    return "The trajectory is not a vtkPolyData. Connect a polyline or points.";
  }
  return {};
}
