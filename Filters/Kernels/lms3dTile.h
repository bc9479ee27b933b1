// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sixteen tiles of a scan's grid, and what a triangle does to each.
 *
 * A tile is a range of turns and beams: a block, a tile or a packet of lms3dTileGrid. All its beams
 * lie in the cone of four directions, its corners: the sides along turns are great circles. A side
 * along beams is not: between two corners at the elevation alpha, the great circle lies farther
 * from the horizon than the beams. So a corner on the side towards the horizon has the elevation
 * atan(tan(alpha) cos(h)) instead, where h is half the angle between the tile's turns; in the
 * middle, the great circle then touches the beams.
 *
 * Each direction in a tile is a sum of its corners with factors that are not negative and add up to
 * 1 or more, since corners are not longer than 1. (Exception: a tile from pole to pole, or from one
 * side of the sensor to the other, is no cone. Its corners then lie on both sides of any plane
 * through its middle, so that no product decides.) So a product that exceeds a positive bound at
 * all four corners exceeds it in the whole tile.
 */
#ifndef lms3dTile_h
#define lms3dTile_h

#include "Kernels/lms3dBeamPacket.h"

#include <cstdint>

/// As many tiles as a packet has beams. Sets of tiles are masks: bit i stands for tile i.
struct lms3dTiles
{
  static constexpr int Size = lms3dBeamPacket::Size;

  /// Cosine and sine of the corners' elevations on the lower and the upper side; the sines are
  /// already corrected as described above.
  alignas(64) float Cosine[2][Size];
  alignas(64) float Sine[2][Size];

  /// The fan's horizontal axis in the first and the last turn.
  alignas(64) float Fan[2][3][Size];

  /// The upward axis.
  float Up[3];

  ///@{
  /// Output of FillTileCorners: the corners around each tile, and the normals of its sides, turned
  /// inwards. Side i joins the corners i and i + 1.
  alignas(64) float Corner[4][3][Size];
  alignas(64) float Side[4][3][Size];
  ///@}
};

/// The nearest triangle that covers each tile: its inverse range at the corners with the error. All
/// zeros: no cover yet.
struct lms3dTileCover
{
  alignas(64) float InverseRange[4][lms3dTiles::Size];
  alignas(64) float Error[lms3dTiles::Size];
};

/// The directions of a triangle's corners, of length 1 in the 1-norm; 0 for a corner at the sensor.
struct lms3dCornerDirections
{
  float Corner[3][3];
};

/// A box relative to the sensor, in any unit: all points whose distance from the centre is at most
/// half the size along each axis.
struct lms3dTileBox
{
  float Center[3];
  float HalfSize[3];
};

struct lms3dTileMasks
{
  /// Tiles in which the triangle may be the nearest for a beam.
  std::uint32_t Met;

  /// Those tiles that the triangle covers for certain, in front of the sensor and within its
  /// maximum range.
  std::uint32_t Covered;

  /// Those covered tiles in which the triangle is nearer than the last cover, which it replaces.
  std::uint32_t Nearest;
};

#endif
