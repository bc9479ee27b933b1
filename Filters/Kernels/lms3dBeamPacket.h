// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Beams that are cast together: neighbours in the grid, which meet the same triangles.
 */
#ifndef lms3dBeamPacket_h
#define lms3dBeamPacket_h

#include <cstdint>
#include <limits>

struct lms3dBeamPacket
{
  static constexpr int Size = 16;
  static constexpr std::int32_t NoTriangle = -1;
  static constexpr double NoRange = std::numeric_limits<double>::infinity();

  /// x, y and z of each beam, in world coordinates.
  alignas(64) double Direction[3][Size];

  /// The same in single precision, with tiny components taken as 0; for culling only.
  alignas(64) float NarrowDirection[3][Size];

  /// The nearest hit, or NoRange.
  alignas(64) double Range[Size];

  /// Its triangle, or NoTriangle.
  alignas(64) std::int32_t Triangle[Size];

  /// Bit i is set where beam i is to be cast.
  std::uint32_t Active;
};

/// From where the beams of a scan start, and how far they reach.
struct lms3dViewpoint
{
  double Origin[3];
  double MaximumRange;
};

#endif
