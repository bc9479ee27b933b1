// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes of the patches of a local map.
 */
#ifndef lms3dPatchFit_h
#define lms3dPatchFit_h

#include "Fusion/Scans/lms3dLocalMap.h"

#include <optional>
#include <vector>

/// The plane that fits the returns of a patch best.
struct lms3dFittedPlane
{
  lms3dVector Centre;
  /// Towards the sensor, with length 1.
  lms3dVector Normal;
  /// The root mean square of the returns' distances, metres.
  double Deviation;
  /// The correlation of the distances of successive returns: near 0 for noise, near 1 for a curved
  /// surface.
  double Correlation = 0.0;
};

/// Returns the numbers of the returns of each patch.
std::vector<std::vector<int>> lms3dGetReturnsOfPatches(const lms3dLocalMap& map);

/// Fits a plane to returns, then again without those that are far from it, since a patch can have
/// returns of what lies beside it. Returns none if they are too few, or too near to a line, for a
/// plane. `smallestWidth` is in metres.
std::optional<lms3dFittedPlane> lms3dFitPlane(
  const lms3dLocalMap& map, const std::vector<int>& returns, double smallestWidth);

#endif
