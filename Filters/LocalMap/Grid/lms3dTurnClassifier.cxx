// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dTurnClassifier.h"

#include <cmath>

lms3dTiltFinder::lms3dTiltFinder(
  const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep, bool areFansSteady)
  : FanStep(fanStep)
  , AreFansSteady(areFansSteady)
{
  double sine, cosine;
  lms3dSinCosDegrees(geometry.GetBetaStep(), sine, cosine);
  this->Weights.reserve(geometry.GetNumberOfBeams());
  for (int beam = 0; beam < geometry.GetNumberOfBeams(); ++beam)
  {
    this->Weights.push_back(GetWeights(geometry, beam, 2.0 * (1.0 - cosine)));
  }
}

// Takes the neighbour towards the horizon. If that lies on another wall of a convex room, the plane
// through it continues behind the true one, so the room stays closed. With the angle s to the
// neighbour, h = sin(e) w + cos(e) (w' - cos(s) w) / sin(s).
lms3dTiltFinder::TiltWeights lms3dTiltFinder::GetWeights(
  const lms3dScanGeometry& geometry, int beam, double scale)
{
  const double sine = geometry.GetAlphaSine(beam);
  const double cosine = geometry.GetAlphaCosine(beam);
  const int neighbor = beam + (sine * geometry.GetAlphaStep() > 0.0 ? -1 : 1);
  if (neighbor < 0 || neighbor >= geometry.GetNumberOfBeams())
  {
    return { NoNeighbor, 0.0, 0.0 };
  }
  const double otherSine = geometry.GetAlphaSine(neighbor);
  const double otherCosine = geometry.GetAlphaCosine(neighbor);
  const double sineOfStep = otherSine * cosine - otherCosine * sine;
  const double cosineOfStep = otherCosine * cosine + otherSine * sine;
  return { neighbor, scale * sine * (sine - cosine * cosineOfStep / sineOfStep),
    scale * sine * cosine / sineOfStep };
}

// Whether a return and the next one in its fan lie on one surface.
bool lms3dTiltFinder::IsOneSurface(int turn, const double* ranges, int beam) const
{
  return this->Fans ? this->Fans->GetRow(turn)[beam] != 0
                    : this->FanStep.IsOneSurface(ranges + beam);
}

lms3dDepthStep::Tilt lms3dTiltFinder::Find(int turn, const double* ranges, int beam) const
{
  const auto& [neighbor, ofRange, ofNeighbor] = this->Weights[beam];
  if (neighbor == NoNeighbor || !(ranges[neighbor] > 0.0) || !(ranges[beam] > 0.0))
  {
    return {};
  }
  const double inverse = 1.0 / ranges[beam];
  const double inverseOfNeighbor = 1.0 / ranges[neighbor];
  const double tilt = ofRange * inverse + ofNeighbor * inverseOfNeighbor;
  const double variance = ofRange * ofRange * this->FanStep.GetVariance(inverse) +
    ofNeighbor * ofNeighbor * this->FanStep.GetVariance(inverseOfNeighbor);
  if (this->IsOneSurface(turn, ranges, std::min(beam, neighbor)))
  {
    return { tilt, variance };
  }
  if (!this->AreFansSteady)
  {
    return {};
  }
  // Both tilts are well within the deviations that lms3dDepthStep allows.
  const double deviation = std::abs(tilt) / lms3dDepthStep::Deviations + std::sqrt(variance);
  return { 0.5 * tilt, deviation * deviation };
}
