// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sums of normals of a piece of a turn, with all that they are made of.
 *
 * The sizes are fixed, so that compilers see that the rows do not overlap, and small enough for the
 * nearest cache.
 */
#ifndef lms3dNormalTile_h
#define lms3dNormalTile_h

#include <cstdint>

/// Goes from turn to turn by lms3dPacketKernels::AddStrip.
struct lms3dNormalTile
{
  /// A multiple of what a vector holds; cells that a tile does not need have no triangles.
  static constexpr int Cells = 64;
  static constexpr int Points = Cells + 1;

  /// Long enough for the points, and for all rows to be aligned.
  template <typename T>
  using Row = T[Cells + 64 / sizeof(T)];

  /// To be set before a strip is added: for each cell bit i where it has a triangle at corner i, and
  /// the coordinates of the next turn.
  alignas(64) Row<std::uint8_t> Triangles;
  Row<double> Next[3];

  /// Coordinates of this turn.
  Row<double> Here[3];
  /// The sides of cells: from turn to turn, and from beam to beam of both turns.
  Row<double> Across[3];
  Row<double> HereSide[3];
  Row<double> NextSide[3];
  /// For each corner of a cell 1 or 0: whether it has a triangle there.
  Row<double> Weight[4];

  /// What cells add at the beam where they begin, and at the one where they end, in both turns.
  Row<double> HereBegin[3];
  Row<double> HereEnd[3];
  Row<double> NextBegin[3];
  Row<double> NextEnd[3];

  /// At a point between two cells of this turn: the sum of the normals of its triangles, each as
  /// long as twice the area, and 1 / its length.
  Row<double> Sum[3];
  Row<double> Scale;
};

#endif
