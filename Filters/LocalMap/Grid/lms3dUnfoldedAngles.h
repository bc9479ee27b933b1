// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The angles of a grid whose turns are the halves of fans along the axis.
 */
#ifndef lms3dUnfoldedAngles_h
#define lms3dUnfoldedAngles_h

#include <array>
#include <vector>

/// All angles are degrees. See lms3dMapGeometry.
struct lms3dUnfoldedAngles
{
  /// Throws std::runtime_error, with a text for the user, if angles are not strictly monotonic.
  /// Both must have at least one.
  lms3dUnfoldedAngles(const std::vector<double>& alphas, const std::vector<double>& betas);

  /// Whether a turn that far from the first one repeats directions.
  static bool IsRepeated(double turned);

  /// Elevations, increasing.
  std::vector<double> Alphas;

  /// All turns of the first half, then all turns of the second.
  std::vector<double> Betas;

  int TurnsOfHalf;

  /// For both halves (alpha > 0 and alpha < 0) and each elevation, the beam of the scan, or -1.
  /// Both have the beam at alpha 0.
  std::array<std::vector<int>, 2> Beams;

  /// Whether the beams of both halves have the same elevations. Otherwise, elevations are means.
  bool AreHalvesEqual;

private:
  void MakeRows(const std::vector<double>& alphas);
  void MakeTurns(const std::vector<double>& betas, double stepOfSingleTurn);
};

#endif
