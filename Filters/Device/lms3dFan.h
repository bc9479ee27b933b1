// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of one fan: when each one leaves, where, and in which direction.
 *
 * The mirror of the LMS 200 turns 75 times a second and measures at each whole degree. Fans of
 * finer steps are interlaced: a fan in steps of half a degree takes two turns of the mirror, first
 * the whole degrees, then the half ones (SICK's telegram listing 8007954, pages 19 and 127). Beam b
 * of a fan in steps of 1/n degree, n a whole number, leaves at
 *
 *     (b mod n) / 75 s + (b div n) / (360 * 75) s.
 *
 * Fans in other steps, and fans of one beam, are measured in one turn of the mirror, each beam at
 * its angle.
 */
#ifndef lms3dFan_h
#define lms3dFan_h

#include "Device/lms3dPlatform.h"
#include "Geometry/lms3dVector.h"

#include <vector>

class lms3dScanGeometry;

/// How often the mirror turns in a second.
constexpr double lms3dMirrorRate = 75.0;

/// Returns the number of turns of the mirror that a fan takes, at least 1.
int lms3dCountMirrorTurns(const lms3dScanGeometry& geometry);

/// Returns the time from one fan to the next, seconds.
double lms3dGetFanPeriod(const lms3dScanGeometry& geometry);

/// The components of a vector are those along F, S and A of the turn's frame (lms3dPlatform.h).
/// Each vector has one element for each beam of the fan.
struct lms3dFan
{
  explicit lms3dFan(const lms3dScanGeometry& geometry);

  /// Seconds since the start of the fan.
  std::vector<double> Times;

  /// Unit vectors.
  std::vector<lms3dVector> Directions;

  /// Metres, relative to the sensor's position.
  std::vector<lms3dVector> Origins;

  /// How far the platform has turned since the start of the fan, degrees.
  std::vector<double> TurnedAngles;

  /// Sines and cosines of these angles.
  std::vector<double> TurnedSines;
  std::vector<double> TurnedCosines;
};

#endif
