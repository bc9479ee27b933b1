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

/// Metres.
using Corners = std::array<Vector, 3>;

/// Powers of ten.
struct Exponents
{
  double Minimum;
  double Maximum;
};

///@{
/// Sizes of triangles relative to their distance: of any triangles, and of the small ones of large
/// scenes.
constexpr Exponents AllSizes = { -4.0, 1.0 };
constexpr Exponents SmallSizes = { -7.0, -1.0 };
///@}

/// Returns a triangle relative to the sensor, at a distance of a millimetre to a hundred metres.
/// Half of them are very narrow or seen nearly edge-on.
Corners MakeTriangle(Random& random, const Exponents& sizes = AllSizes);

Corners Scale(const Corners& corners, double scale);

/// A factor that differs from 1 by ten to a power between two exponents.
double GetNearlyOne(Random& random, double least, double most);

/// The part of a vector that has a right angle with a direction of length 1. Its length is 1.
Vector GetAcross(const Vector& vector, const Vector& direction);

/// Two triangles, and a packet aimed at where they are most easily taken for hit or missed.
struct Attack
{
  Corners First;
  Corners Second;
  std::array<Vector, lms3dBeamPacket::Size> Beams;
};

/// The second triangle is a needle as long as its distance. Its plane is uncertain by much more
/// than that of the first, which lies just behind it or in front of it.
Attack MakeNeedle(Random& random);

/// Both triangles are tiny, in one place and seen nearly edge-on: their edges have nearly the same
/// plane. Beams lie in that plane, far from the triangles.
Attack MakeTinyTriangles(Random& random);

/// Returns the origin of world coordinates, or in half of the cases a point up to a hundred metres
/// away.
Vector MakeSensor(Random& random);

/// A triangle in world coordinates, and the sensor that sees it.
class SeenTriangle
{
public:
  /// Takes corners relative to the sensor. In world coordinates they are rounded; that triangle is
  /// the true one.
  SeenTriangle(const Corners& corners, const Vector& sensor);

  lms3dSensorFrameTriangle GetInSensorFrame() const;

  /// Returns pointers to this object, with a metre as unit.
  lms3dCornerPoints GetPoints() const;

  /// Returns the range of a beam with all digits, metres; infinite if the beam passes by or the
  /// triangle is behind the sensor.
  double GetRange(const Vector& direction) const;

private:
  Corners World;
  Vector Sensor;
};

#endif
