// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of one tile, whose ranges are computed at once.
 */
#ifndef lms3dTileBeams_h
#define lms3dTileBeams_h

#include <array>

/// Some turns and up to lms3dBeamPacket::Size beams of a scan's grid. The arrays belong to the
/// caller.
struct lms3dBeamsOfTile
{
  /// Cosine and sine of the elevation of each beam.
  const double* Cosines;
  const double* Sines;

  /// The fan's horizontal axis in each turn, and the upward axis, in world coordinates.
  const std::array<double, 3>* FanAxes;
  const double* Up;

  int Turns;
  int Beams;
};

/// Metres.
struct lms3dRangeWindow
{
  double Minimum;
  double Maximum;
};

#endif
