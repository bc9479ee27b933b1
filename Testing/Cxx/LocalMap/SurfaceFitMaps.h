// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans of a ball around the sensor, and maps of it whose triangles are large.
 */
#ifndef SurfaceFitMaps_h
#define SurfaceFitMaps_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <cstdint>
#include <functional>
#include <map>

/// The scan of a ball.
struct BallScan
{
  /// Metres.
  static constexpr double Radius = 2.0;
  static constexpr int Beams = 91;
  static constexpr int Turns = 90;

  /// `getRange` takes the numbers of the beam and the turn, and returns metres, or 0 if the beam
  /// has no return.
  explicit BallScan(
    const std::function<double(int, int)>& getRange = [](int, int) { return Radius; },
    int beams = Beams);

  /// Degrees.
  static constexpr double Alpha[2] = { -90.0, 90.0 };
  static constexpr double Beta[2] = { 0.0, 360.0 };
  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
};

/// An octahedron whose faces are divided into four twice, with all vertices on a sphere. The
/// triangles face the sensor.
class RoundMap
{
public:
  /// The radius is in metres. Starts with an octant; those from 4 on are below the sensor.
  explicit RoundMap(double radius, int firstOctant = 0);

  const lms3dBoundedMap& Get() const { return this->Map; }

private:
  std::int32_t Add(const lms3dVector& direction);

  const double Size;
  std::map<lms3dVector, std::int32_t> Numbers;
  lms3dBoundedMap Map;
};

/// The vertex in a direction, a unit vector. There must be one.
std::int32_t FindVertex(const lms3dVertexStars& stars, const lms3dVector& direction);

#endif
