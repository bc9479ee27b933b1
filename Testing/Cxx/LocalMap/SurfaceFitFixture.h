// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fits maps to the returns of a ball and measures how far the returns are from them.
 */
#ifndef SurfaceFitFixture_h
#define SurfaceFitFixture_h

#include "LocalMap/Bounded/lms3dSurfaceFit.h"
#include "LocalMap/Patches/lms3dPatches.h"
#include "LocalMap/SurfaceFitMaps.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

/// A ball around the sensor whose returns are one patch.
class SurfaceFit : public testing::Test
{
protected:
  static constexpr double Radius = BallScan::Radius;
  static constexpr int Turns = BallScan::Turns;

  /// The distances of the returns from a map along their beams, metres.
  struct Distances
  {
    double Largest = 0.0;
    double SumOfSquares = 0.0;
  };

  SurfaceFit();

  /// Fits the chosen vertices. `bound` is the largest distance of a return, metres.
  void Fit(double bound, const std::vector<std::uint8_t>& isChosen, lms3dVertexStars& stars) const;
  /// Fits all vertices.
  void FitAll(double bound, lms3dVertexStars& stars) const;

  /// Measures the distances of the returns of the ball.
  Distances Measure(const lms3dVertexStars& stars) const;

  const BallScan Scan;
  const lms3dBeamSphere Sphere;
  lms3dPatches Patches;
};

#endif
