// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene and beams at it, for any ray caster.
 */
#ifndef StabilityCase_h
#define StabilityCase_h

#include "Fixtures/BeamFixtures.h"

#include <vector>

/// A packet of beams from one place.
struct StabilityShot
{
  Vector Sensor;
  Beams Directions;
};

struct StabilityCase
{
  /// Triangles may have corners that are not finite.
  lms3dTriangleMesh Mesh;
  std::vector<StabilityShot> Shots;
};

#endif
