// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dTurnClassifier.h"

lms3dTiltFinder::lms3dTiltFinder(const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep)
  : FanStep(fanStep)
{
  double sine, cosine;
  lms3dSinCosDegrees(geometry.GetBetaStep(), sine, cosine);
  this->Weights.reserve(geometry.GetNumberOfBeams());
  for (int beam = 0; beam < geometry.GetNumberOfBeams(); ++beam)
  {
    this->Weights.push_back(GetWeights(geometry, beam, 2.0 * (1.0 - cosine)));
  }
}

// Takes the neighbour towards the horizon. If that lies on another wall of a convex room, the plane through
// it continues behind the true one, so the room stays closed. With the angle s to the neighbour,
// h = sin(e) w + cos(e) (w' - cos(s) w) / sin(s).
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
