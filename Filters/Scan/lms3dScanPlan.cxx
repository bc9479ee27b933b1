// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanPlan.h"

#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
std::vector<lms3dElevations> MakeElevations(const lms3dScanGeometry& geometry)
{
  const int beams = geometry.GetNumberOfBeams();
  std::vector<lms3dElevations> elevations(lms3dBeamGrid::CountPackets(beams));
  for (std::size_t column = 0; column < elevations.size(); ++column)
  {
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      const int first = static_cast<int>(column) * lms3dPacketGrid::Side;
      const int beam = std::min(first + i % lms3dPacketGrid::Side, beams - 1);
      elevations[column].Cosine[i] = geometry.GetAlphaCosine(beam);
      elevations[column].Sine[i] = geometry.GetAlphaSine(beam);
    }
  }
  return elevations;
}

// Results must not depend on earlier scans, so zeros may not differ in sign.
bool AreSame(const lms3dVector& a, const lms3dVector& b)
{
  return std::equal(a.begin(), a.end(), b.begin(),
    [](double x, double y) { return x == y && std::signbit(x) == std::signbit(y); });
}
} // namespace

lms3dScanPlan::lms3dScanPlan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, double maximumRange)
  : Caster(caster.GetSerialNumber())
  , Geometry(geometry.GetSerialNumber())
  , Pose(pose)
  , Directions(geometry, pose)
  , Elevations(MakeElevations(geometry))
  , Origin{ { pose.Position[0], pose.Position[1], pose.Position[2] }, maximumRange }
  , Grid{ geometry.GetNumberOfTurns(), geometry.GetNumberOfBeams() }
  , GridCaster(caster.NewGridCaster(this->Origin, this->MakeGrid(geometry)))
{
}

bool lms3dScanPlan::Fits(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, double maximumRange) const
{
  return caster.GetSerialNumber() == this->Caster && geometry.GetSerialNumber() == this->Geometry &&
    AreSame(pose.Position, this->Pose.Position) &&
    std::equal(pose.Axes.begin(), pose.Axes.end(), this->Pose.Axes.begin(), AreSame) &&
    maximumRange == this->Origin.MaximumRange;
}

// In fans along the axis, elevations decrease from 180 degrees.
lms3dBeamGrid lms3dScanPlan::MakeGrid(const lms3dScanGeometry& geometry) const
{
  if (geometry.GetPlatform().IsFanAlongAxis())
  {
    return { this->Grid.Turns, this->Grid.Beams };
  }
  return { this->Grid.Turns, this->Grid.Beams, &this->Directions.GetFanAxis(0),
    geometry.GetBetaStep(), geometry.GetAlphaCosines().data(), geometry.GetAlphaSines().data(),
    this->Directions.GetUp() };
}
