// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dMapGeometry.h"

#include "LocalMap/Grid/lms3dUnfoldedAngles.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{
constexpr double HalfCircle = 180.0;

// The mirror's centre in the frame of the map, while the platform angle is 0. Its height is 0.
lms3dPlatform MakePlatform(const lms3dPlatform& scanned)
{
  const lms3dVector offset = lms3dToPlatformAxes(scanned.Mounting, scanned.AxisOffset);
  return { lms3dMounting::Yawing, { offset[0], offset[1], 0.0 }, scanned.TurnRate };
}

void CheckSize(const lms3dUnfoldedAngles& unfolded)
{
  const std::size_t beams = unfolded.Alphas.size() * unfolded.Betas.size();
  if (beams > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw std::runtime_error("The two halves of the fans have " + std::to_string(beams) +
      " directions; at most 2147483647 are possible. Choose lower resolutions.");
  }
}

// Turns a vector of a turn's frame to the frame of the map.
lms3dVector ToMap(const lms3dVector& v, double degrees)
{
  double sine, cosine;
  lms3dSinCosDegrees(degrees, sine, cosine);
  return { cosine * v[0] + sine * v[1], cosine * v[1] - sine * v[0], v[2] };
}
} // namespace

lms3dScanGeometry lms3dMapGeometry::MakeGrid(
  const lms3dScanGeometry& scanned, std::array<Half, 2>& halves, int& turnsOfHalf, bool& isRegular)
{
  const lms3dPlatform platform = MakePlatform(scanned.GetPlatform());
  isRegular = platform.IsCentredAndStepped();
  if (!scanned.GetPlatform().IsFanAlongAxis())
  {
    turnsOfHalf = scanned.GetNumberOfTurns();
    for (int beam = 0; beam < scanned.GetNumberOfBeams(); ++beam)
    {
      halves[0].Beams.push_back(beam);
    }
    return { scanned.GetAlphaAngles(), scanned.GetBetaAngles(), platform };
  }
  const lms3dUnfoldedAngles unfolded(scanned.GetAlphaAngles(), scanned.GetBetaAngles());
  CheckSize(unfolded);
  isRegular = isRegular && unfolded.AreHalvesEqual;
  turnsOfHalf = unfolded.TurnsOfHalf;
  halves[0].Beams = unfolded.Beams[0];
  halves[1].Beams = unfolded.Beams[1];
  return { unfolded.Alphas, unfolded.Betas, platform };
}

lms3dMapGeometry::lms3dMapGeometry(const lms3dScanGeometry& scanned)
  : Scanned(scanned)
  , IsUnfolded(scanned.GetPlatform().IsFanAlongAxis())
  , Grid(MakeGrid(scanned, this->Halves, this->TurnsOfHalf, this->Regular))
  , Fan(scanned)
  , Height(lms3dToPlatformAxes(scanned.GetPlatform().Mounting, scanned.GetPlatform().AxisOffset)[2])
  , Places(scanned.GetNumberOfBeams(), { 0, NoBeam })
{
  for (int half = 1; half >= 0; --half)
  {
    this->FillTurnedSteps(this->Halves[half]);
    const std::vector<int>& beams = this->Halves[half].Beams;
    for (std::size_t beam = 0; beam < beams.size(); ++beam)
    {
      if (beams[beam] != NoBeam)
      {
        this->Places[beams[beam]] = { half, static_cast<int>(beam) };
      }
    }
  }
}

void lms3dMapGeometry::FillTurnedSteps(Half& half) const
{
  const double step = this->Grid.GetBetaStep();
  if (this->Scanned.GetPlatform().TurnRate == 0.0 || step == 0.0)
  {
    return;
  }
  for (int beam : half.Beams)
  {
    half.TurnedSteps.push_back(beam == NoBeam ? 0.0 : this->Fan.TurnedAngles[beam] / step);
  }
}

double lms3dMapGeometry::GetDistanceFromAxis() const
{
  const lms3dVector& offset = this->Grid.GetPlatform().AxisOffset;
  return std::hypot(offset[0], offset[1]);
}

int lms3dMapGeometry::GetBeamId(int beamId) const
{
  if (!this->IsUnfolded)
  {
    return beamId;
  }
  const int turn = beamId / this->Scanned.GetNumberOfBeams();
  const auto [half, beam] = this->Places[beamId % this->Scanned.GetNumberOfBeams()];
  const double turned =
    std::abs(this->Scanned.GetBetaAngles()[turn] - this->Scanned.GetBetaAngles()[0]);
  return lms3dUnfoldedAngles::IsRepeated(turned)
    ? NoBeam
    : (half * this->TurnsOfHalf + turn) * this->Grid.GetNumberOfBeams() + beam;
}

bool lms3dMapGeometry::IsBeyondAxis(int turn, int beam, double range) const
{
  const double ahead = this->Grid.GetPlatform().AxisOffset[0];
  return (this->GetHalf(turn) == 1 ? -ahead : ahead) + range * this->Grid.GetAlphaCosine(beam) <
    0.0;
}

lms3dMapRay lms3dMapGeometry::GetRay(int turn, int beam) const
{
  const int half = this->GetHalf(turn);
  const double beta = this->Grid.GetBetaAngles()[turn];
  // The platform angle of a half fan on the other side of the axis.
  const double platformAngle = half == 1 ? beta - HalfCircle : beta;
  const int measured = this->Halves[half].Beams[beam];
  if (measured != NoBeam)
  {
    const lms3dVector& origin = this->Fan.Origins[measured];
    return { ToMap({ origin[0], origin[1], 0.0 }, platformAngle),
      ToMap(this->Fan.Directions[measured], platformAngle) };
  }
  return { ToMap(this->Grid.GetPlatform().AxisOffset, platformAngle),
    ToMap({ this->Grid.GetAlphaCosine(beam), 0.0, this->Grid.GetAlphaSine(beam) }, beta) };
}

const double* lms3dMapGeometry::GetTurnedSteps(int turn) const
{
  const std::vector<double>& steps = this->Halves[this->GetHalf(turn)].TurnedSteps;
  return steps.empty() ? nullptr : steps.data();
}

int lms3dMapGeometry::GetInterlacedBeams() const
{
  return this->Scanned.GetPlatform().TurnRate == 0.0 ? 1 : lms3dCountMirrorTurns(this->Scanned);
}
