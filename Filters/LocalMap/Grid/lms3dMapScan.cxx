// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dMapScan.h"

#include "Device/lms3dScanInput.h"

#include <algorithm>
#include <cmath>

lms3dMapScan::lms3dMapScan(const lms3dScanInput& scan, const lms3dMapGeometry& geometry)
  : Geometry(geometry)
  , Count(scan.GetNumberOfReturns())
  , Ranges(scan.GetRanges())
  , BeamIds(scan.GetBeamIds())
  , Points(scan.GetPoints())
  , Distances(this->Ranges)
{
  this->SetFrame(scan);
  if (!geometry.IsAsScanned())
  {
    this->Unfold(scan);
  }
  if (geometry.GetDistanceFromAxis() > 0.0)
  {
    this->MeasureDistances();
  }
}

// The default mounting keeps the numbers of SensorToWorld to the bit.
void lms3dMapScan::SetFrame(const lms3dScanInput& scan)
{
  std::copy_n(scan.GetSensorToWorld(), 16, this->MapToWorld.begin());
  const lms3dMounting mounting = this->Geometry.GetScanned().GetPlatform().Mounting;
  const std::array<lms3dVector, 3> axes = lms3dGetPlatformAxes(mounting, scan.GetPose().Axes);
  const double height = this->Geometry.GetHeight();
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->MapToWorld[4 * row + axis] = axes[axis][row];
    }
    if (height != 0.0)
    {
      this->MapToWorld[4 * row + 3] += height * axes[2][row];
    }
  }
}

void lms3dMapScan::Unfold(const lms3dScanInput& scan)
{
  const std::int64_t beams = this->Geometry.GetScanned().CountBeamsOfAllTurns();
  const std::int64_t all = scan.GetNumberOfReturns();
  for (std::int64_t i = 0; i < all; ++i)
  {
    const int beamId = scan.GetBeamIds()[i];
    if (beamId < 0 || beamId >= beams)
    {
      lms3dThrowBadReturn(i, scan.GetRanges()[i], beamId, beams);
    }
    const int place = this->Geometry.GetBeamId(beamId);
    if (place != lms3dMapGeometry::NoBeam)
    {
      const double* point = scan.GetPoints() + 3 * i;
      this->OwnRanges.push_back(scan.GetRanges()[i]);
      this->OwnBeamIds.push_back(place);
      this->OwnPoints.insert(this->OwnPoints.end(), point, point + 3);
    }
  }
  this->Count = static_cast<std::int64_t>(this->OwnRanges.size());
  this->Repeated = all - this->Count;
  this->Ranges = this->OwnRanges.data();
  this->BeamIds = this->OwnBeamIds.data();
  this->Points = this->OwnPoints.data();
  this->Distances = this->Ranges;
}

void lms3dMapScan::MeasureDistances()
{
  const lms3dVector origin = this->GetOrigin();
  this->OwnDistances.reserve(this->Count);
  for (std::int64_t i = 0; i < this->Count; ++i)
  {
    const double* point = this->Points + 3 * i;
    this->OwnDistances.push_back(
      std::hypot(point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]));
  }
  this->Distances = this->OwnDistances.data();
}
