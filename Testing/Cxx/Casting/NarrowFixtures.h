// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles on which single precision is most likely to fail, and the truth about them.
 */
#ifndef NarrowFixtures_h
#define NarrowFixtures_h

#include "Fixtures/VectorFixtures.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>

/// World coordinates, metres. The sensor is at the origin.
using Corners = std::array<Vector, 3>;

/// Returns a triangle at a distance of a millimetre to a hundred metres. Half of them are very narrow or
/// seen nearly edge-on.
Corners MakeTriangle(Random& random);

lms3dSensorFrameTriangle GetInSensorFrame(const Corners& corners);

/// Returns the range of a beam with all digits, metres; infinite if the beam passes by or the triangle
/// is behind the sensor.
double GetRange(const Corners& corners, const Vector& direction);

#endif
