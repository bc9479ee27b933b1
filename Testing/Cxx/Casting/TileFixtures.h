// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tiles on which single precision is most likely to fail.
 */
#ifndef TileFixtures_h
#define TileFixtures_h

#include "Casting/NarrowFixtures.h"
#include "Fixtures/VectorFixtures.h"
#include "Kernels/lms3dPacketKernels.h"

/// A block, a tile or a packet that is a whole grid: from the first to the last angle, degrees. The
/// sensor is not upright.
struct Tile
{
  double Alpha[2];
  double Beta[2];
  int Level;

  static Tile Make(Random& random);
  static Tile MakeNearlyFromPoleToPole(Random& random);

  /// From a quarter of the sphere on, with narrow and with wide turns.
  static Tile MakeWide(Random& random);

  /// As thin as a few roundings of single precision, and nearly as long as a side of a tile can be
  /// whose turning is certain.
  static Tile MakeThin(Random& random);

  /// A few degrees wide.
  static Tile MakeSmall(Random& random);

  ///@{
  /// Returns a direction in the tile: at shares of its angles, or often on a side or at a corner.
  Vector GetDirection(double alphaShare, double betaShare) const;
  Vector GetDirection(Random& random) const;
  ///@}

  /// All sixteen tiles are the same.
  void Fill(lms3dTiles& tiles) const;
};

/// Returns what a triangle does to tile 0. `cover` has the last cover. Ranges in metres.
lms3dTileMasks ClassifyTile(const lms3dTiles& tiles, const SeenTriangle& triangle,
  double maximumRange, lms3dTileCover& cover);

#endif
