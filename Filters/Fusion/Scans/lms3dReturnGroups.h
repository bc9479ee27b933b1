// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the planes in which some returns of several scans lie.
 */
#ifndef lms3dReturnGroups_h
#define lms3dReturnGroups_h

#include "Fusion/Scans/lms3dLocalMap.h"

#include <vector>

/// Returns that one plane explains. World coordinates, metres.
struct lms3dReturnGroup
{
  lms3dVector Centre;
  /// Towards the sensors, with length 1.
  lms3dVector Normal;
  /// The root mean square of the distances of the returns that lie on the plane.
  double Deviation;
  std::vector<int> Returns;
};

/// Returns the groups, that with most returns on its plane first. A return is in one group at most.
/// Returns near a line become a group, too: its plane is across their beams. `bound` is how far a
/// return may be from the plane of its group, metres. Planes go through three returns, and are then
/// fitted to the returns near them (M. Fischler and R. Bolles 1981, "Random sample consensus").
/// Which three is fixed, so the result is always the same.
std::vector<lms3dReturnGroup> lms3dGroupReturns(
  const std::vector<lms3dMappedReturn>& returns, double bound);

#endif
