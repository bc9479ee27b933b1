// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins returns that beams graze, if the returns beside them show one plane.
 */
#ifndef lms3dGrazedStrips_h
#define lms3dGrazedStrips_h

#include "LocalMap/Grid/lms3dPaddedGrid.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <array>
#include <cstdint>

/**
 * Beams nearly at the height of a table meet its top far apart, so each fan has two or three
 * returns on it. That is too few for lms3dDepthStep. But the same beams of the turns beside it meet
 * the top, too. Their returns form two strips, one for each beam of the pair. Both strips lie on
 * one surface if
 *
 * - beams of a fan are at most two degrees apart,
 * - each is joined along its turns, over at least five turns (up to 15 on either side are used),
 * - one plane fits both within 2 % of the depth step and 4.5 standard deviations of the noise, and
 *   also the return before or behind the pair in the fan,
 * - one upright plane for each strip, as of walls on both sides of a depth step, fits worse. The
 *   sum of the squared residuals is larger by more than 4.5 standard deviations squared, where a
 *   standard deviation is that of the noise plus 1 % of the depth step, and
 * - neither strip continues on another plane, which it and two returns beyond it show.
 *
 * On a plane, the inverse range is a linear function of the beam's direction. Strips at the horizon
 * say nothing, as every plane looks upright there.
 */
class lms3dGrazedStrips
{
public:
  using Flags = lms3dPaddedGrid<std::uint8_t>;

  /// Keeps references. `joins` are the certain joins, whose halo is not read. `depthStep` and
  /// `noise`, the standard deviation of ranges, are metres.
  lms3dGrazedStrips(const lms3dRangeGrid& grid, const Flags& joins, double depthStep, double noise);

  /// Whether a return and that of the next beam lie on one plane. Both have returned.
  bool AreOneSurface(int turn, int beam) const;

private:
  static constexpr int MaximumReach = 15;

  /// The turns before and behind the pair that belong to the strips.
  struct Window
  {
    int Before;
    int Behind;
  };

  /// The inverse range is X times the cosine of the angle turned since the pair, plus Y times its
  /// sine, plus Up, where the elevation's cosine is a factor of X and Y and its sine one of Up.
  struct Plane
  {
    double X = 0.0;
    double Y = 0.0;
    double Up = 0.0;
  };

  /// The cosine and the sine of an angle.
  struct Turned
  {
    double Cosine;
    double Sine;
  };

  const Turned& GetTurned(int offset) const { return this->TurnedBy[offset + MaximumReach]; }
  bool IsOnPlane(int turn, int beam, const Plane& plane) const;
  bool LeavesPlane(int turn, int beam, int outwards, const Plane& plane) const;
  double GetRange(int turn, int beam) const;
  int CountJoined(int turn, int beam, int direction) const;
  bool IsOnePlane(int turn, int beam, const Window& window) const;
  Plane FitPlane(int turn, int beam, const Window& window) const;
  Plane FitUpright(int turn, int beam, const Window& window) const;
  double GetResidual(int turn, int beam, int offset, const Plane& plane) const;

  const lms3dRangeGrid& Grid;
  const Flags& Joins;
  double Tolerance;
  double ToleranceBeyond;
  double Deviation;
  double TwoCosines;
  bool IsFine;
  std::array<Turned, 2 * MaximumReach + 1> TurnedBy;
};

#endif
