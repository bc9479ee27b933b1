// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes on which the beams of a scan end.
 */
#ifndef lms3dPlanesOfBeams_h
#define lms3dPlanesOfBeams_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dLocalMap.h"

#include <array>
#include <vector>

/// The plane of a beam is that of the patch of its return, if the return is within the bound of it.
class lms3dPlanesOfBeams
{
public:
  /// The first beams of four successive turns.
  using Turns = std::array<int, 4>;

  /// The scan has `beams` beams. `planeOfPatch` has -1 for a patch without a plane. The threads
  /// divide returns.
  lms3dPlanesOfBeams(const lms3dLocalMap& local, int beams, const std::vector<int>& planeOfPatch,
    const lms3dFusedPlanes& planes);

  /// -1 if a beam has no plane.
  int GetPlane(int beam) const { return this->Planes[beam]; }

  /// The number of the return of a beam in the local map, -1 if it has none.
  int GetReturn(int beam) const { return this->Returns[beam]; }

  /// The places in the fan at which four successive beams of four turns do not have one plane. The
  /// place is that of the first of the four. A turn has `beams` beams.
  std::vector<int> FindMixed(const Turns& turns, int beams) const;

private:
  bool HasOnePlane(const Turns& turns, int beam) const;
  bool HaveOnePlane(const Turns& turns, int beam, int beams) const;

  std::vector<int> Planes;
  std::vector<int> Returns;
};

#endif
