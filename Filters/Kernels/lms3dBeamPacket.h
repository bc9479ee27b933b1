// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Beams that are cast together, and their nearest hits.
 *
 * The beams of a packet are neighbours in the scan's grid, so that they traverse the same nodes of
 * the acceleration structure and meet the same triangles.
 */
#ifndef lms3dBeamPacket_h
#define lms3dBeamPacket_h

#include <cstdint>
#include <limits>

struct lms3dBeamPacket
{
  /// The number of rays in Embree's largest packet.
  static constexpr int Size = 16;
  static constexpr std::int32_t NoTriangle = -1;
  static constexpr double NoRange = std::numeric_limits<double>::infinity();

  /// x, y and z of each beam's direction in world coordinates, of length 1 within rounding.
  alignas(64) double Direction[3][Size];

  /// The same in single precision, with components below 1e-15 set to 0.
  alignas(64) float NarrowDirection[3][Size];

  /// The range of the nearest hit, metres, or NoRange.
  alignas(64) double Range[Size];

  /// The triangle of the nearest hit, an index into the mesh, or NoTriangle.
  alignas(64) std::int32_t Triangle[Size];

  /// Bit i is set if beam i is to be cast. The results of other beams are undefined.
  std::uint32_t Active;
};

/// Beams with a start of their own each. The caller sets Origin, Direction and Active; a cast
/// overwrites the other arrays. Beams that are not active may start anywhere, also at no number.
struct lms3dFreePacket : lms3dBeamPacket
{
  /// x, y and z of each beam's start in world coordinates, metres.
  alignas(64) double Origin[3][Size];
};

/// Where the beams of a scan start, in world coordinates, and the largest range that counts, both
/// in metres. MaximumRange is above 0 and may be infinite.
struct lms3dRayOrigin
{
  double Position[3];
  double MaximumRange;
};

#endif
