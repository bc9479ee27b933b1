// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tiles on which single precision is most likely to fail.
 */
#ifndef TileFixtures_h
#define TileFixtures_h

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

  /// Returns a direction in the tile, often on a side or at a corner.
  Vector GetDirection(Random& random) const;

  /// All sixteen tiles are the same.
  void Fill(lms3dTiles& tiles) const;
};

#endif
