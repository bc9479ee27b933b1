// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dDetection.h"

#include "Scan/lms3dBeamStatus.h"
#include "Scan/lms3dWeakReturns.h"
#include "Scene/lms3dSceneReflectance.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr lms3dRangeLimits NoLimits = { 0.0, Infinity };

// The share of the first cast if there is a second one.
constexpr double CastShare = 0.6;

bool UsesReflectances(const lms3dDeviceSettings& device)
{
  return !device.Reflectance.Array.empty() &&
    (device.Reflectance.RangeAtTenPercent > 0.0 || device.Arrays.Intensity);
}

// Whether a beam without a return can have met a surface.
bool LimitsCount(const lms3dScanSettings& settings)
{
  return settings.Limits.Minimum > NoLimits.Minimum || settings.Limits.Maximum < NoLimits.Maximum;
}

double GetCastShare(const lms3dScanSettings& settings)
{
  return settings.Device.Arrays.Status && LimitsCount(settings) ? CastShare : 1.0;
}
} // namespace

void lms3dDetection::ReadReflectances(
  const lms3dScanSettings& settings, const lms3dBuiltScene& built, vtkDataObject* scene)
{
  const std::string& array = settings.Device.Reflectance.Array;
  if (!UsesReflectances(settings.Device) || !built.GetCaster())
  {
    this->Reflectances = {};
    this->Scene = nullptr;
    return;
  }
  if (this->Scene == scene && this->SceneTime == built.GetSceneTime() &&
    this->BuildTime == built.GetBuildTime() && this->Array == array)
  {
    return;
  }
  this->Scene = nullptr;
  this->Reflectances =
    lms3dGetReflectances(scene, array, built.GetPart().HasGlobalIds, built.GetCaster()->GetMesh());
  this->Scene = scene;
  this->SceneTime = built.GetSceneTime();
  this->BuildTime = built.GetBuildTime();
  this->Array = array;
}

lms3dProgress lms3dDetection::GetCastProgress(
  const lms3dProgress& scan, const lms3dScanSettings& settings)
{
  return lms3dGetStepProgress(scan, 0.0, GetCastShare(settings));
}

bool lms3dDetection::Run(const lms3dDetectionRequest& request, lms3dScanOutput& output)
{
  const lms3dDeviceSettings& device = request.Settings.Device;
  this->Discard();
  if (device.Arrays.Status && !this->FindUnlimited(request, output))
  {
    return false;
  }
  if (device.Reflectance.RangeAtTenPercent > 0.0)
  {
    this->RemoveWeakReturns(request, output);
  }
  if (device.Arrays.Status)
  {
    request.Cast.Processes.RunCollectively([&] { this->MakeStatus(request, output); });
  }
  return true;
}

// A second cast, rather than one cast without limits whose far ranges are removed: close to the
// limits, the first one decides by them, so its returns stay the same to the bit.
bool lms3dDetection::FindUnlimited(
  const lms3dDetectionRequest& request, const lms3dScanOutput& output)
{
  this->HasUnlimited = LimitsCount(request.Settings) && output.HasMissingReturns();
  return !this->HasUnlimited || this->CastUnlimited(request);
}

bool lms3dDetection::CastUnlimited(const lms3dDetectionRequest& request)
{
  const lms3dProgress progress =
    lms3dGetStepProgress(request.Progress, GetCastShare(request.Settings), 1.0);
  const lms3dBeamCastRequest& cast = request.Cast;
  return lms3dCastBeams(
    { cast.Caster, cast.FirstCell, cast.Geometry, cast.Pose, cast.Beams, cast.Footprint, NoLimits,
      cast.Processes, cast.Threads, cast.NumberOfThreads, progress },
    this->Unlimited);
}

void lms3dDetection::RemoveWeakReturns(
  const lms3dDetectionRequest& request, lms3dScanOutput& output)
{
  request.Cast.Processes.RunCollectively(
    [&]
    {
      if (!request.Cast.Caster)
      {
        this->IsWeak.resize(output.GetOwnTriangles().size());
      }
      else
      {
        request.Cast.Threads.Run(request.Cast.NumberOfThreads,
          [&]
          {
            this->IsWeak =
              lms3dFindWeakReturns({ { request.Cast.Caster->GetMesh(), this->Reflectances },
                                     *request.Beams, output.GetOwnTriangles() },
                output.GetRanges(), request.Settings.Device.Reflectance.RangeAtTenPercent);
          });
      }
    });
  lms3dReduceToLargest(request.Controller, this->IsWeak.data(), this->IsWeak.size());
  output.RemoveReturns(this->IsWeak);
}

void lms3dDetection::MakeStatus(const lms3dDetectionRequest& request, const lms3dScanOutput& output)
{
  const lms3dBeamOutcomes outcomes = { output.GetRanges(),
    this->HasUnlimited ? this->Unlimited.GetRanges() : nullptr,
    this->IsWeak.empty() ? nullptr : this->IsWeak.data(), request.Settings.Limits.Minimum };
  request.Cast.Threads.Run(request.Cast.NumberOfThreads,
    [&] { this->Status = lms3dMakeStatus(outcomes, output.GetOwnTriangles().size()); });
}

void lms3dDetection::AddStatus(
  const lms3dScanGeometry& geometry, vtkPolyData* scan, vtkImageData* image) const
{
  if (!this->Status)
  {
    return;
  }
  if (scan)
  {
    lms3dAddStatus(this->Status, scan->GetFieldData());
  }
  lms3dAddStatus(this->Status, geometry.GetNumberOfBeams(), image);
}

void lms3dDetection::CopyStatus(vtkUnsignedCharArray* status) const
{
  if (this->Status)
  {
    const vtkIdType beams = this->Status->GetNumberOfValues();
    status->SetNumberOfValues(beams);
    std::copy_n(this->Status->GetPointer(0), beams, status->GetPointer(0));
    status->Modified();
  }
}

void lms3dDetection::Discard()
{
  this->Unlimited.Discard();
  this->HasUnlimited = false;
  this->IsWeak = {};
  this->Status = nullptr;
}
