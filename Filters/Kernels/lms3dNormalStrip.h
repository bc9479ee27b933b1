// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sums of the normals at the points of a part of a turn, with all intermediate values.
 *
 * The sizes are fixed, so that compilers see that the rows do not overlap, and small enough for the
 * first-level cache. Coordinates are in metres, in any frame.
 */
#ifndef lms3dNormalStrip_h
#define lms3dNormalStrip_h

#include <cstdint>

/// lms3dPacketKernels::AddStrip advances a strip by one turn.
struct lms3dNormalStrip
{
  /// A multiple of the width of vector registers. Unused cells have no triangles.
  static constexpr int Cells = 64;
  static constexpr int Points = Cells + 1;

  /// Long enough for the points, and for all rows to be aligned.
  template <typename T>
  using Row = T[Cells + 64 / sizeof(T)];

  /// Input of AddStrip: for each cell bit i if the cell has a triangle at corner i, and the
  /// coordinates of the points of the next turn.
  alignas(64) Row<std::uint8_t> Triangles;
  Row<double> Next[3];

  /// The coordinates of this turn's points.
  Row<double> Here[3];
  /// The sides of cells: from turn to turn, and from beam to beam in this and in the next turn.
  Row<double> Across[3];
  Row<double> HereSide[3];
  Row<double> NextSide[3];
  /// For each corner of a cell: 1 if the cell has a triangle there, otherwise 0.
  Row<double> Weight[4];

  /// The sums that each cell adds to its four points: at its first and its last beam, in both
  /// turns.
  Row<double> HereBegin[3];
  Row<double> HereEnd[3];
  Row<double> NextBegin[3];
  Row<double> NextEnd[3];

  /// Output of AddStrip for the points between two cells of this turn: the sum of the normals of
  /// the point's triangles, each as long as twice the triangle's area, and 1 / the length of that
  /// sum.
  Row<double> Sum[3];
  Row<double> Scale;
};

#endif
