// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins the local map of a scan to the planes of a fused map.
 */
#ifndef lms3dScanJoin_h
#define lms3dScanJoin_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dLocalMap.h"
#include "Fusion/Scans/lms3dPatchFit.h"

#include <map>
#include <vector>

/// Patches join planes that explain them, or become planes. Curved patches that the map explains
/// already are left out. The triangles of other patches become regions of their own if the map does
/// not explain their returns.
class lms3dScanJoin
{
public:
  /// Keeps references.
  lms3dScanJoin(const lms3dLocalMap& local, const lms3dSeenRanges& ranges, lms3dFusedPlanes& planes)
    : Local(local)
    , Ranges(ranges)
    , Planes(planes)
  {
  }

  void Join();

private:
  /// A patch with a plane.
  struct PatchOfPlane
  {
    int Number;
    const std::vector<int>* Returns;
    /// The root mean square of the returns' distances, metres.
    double Deviation;
    /// The returns that are far from the plane.
    std::vector<int> Loose;
  };

  /// The patches of each plane, in order.
  using PatchesOfPlanes = std::map<int, std::vector<PatchOfPlane>>;

  void AddIfJoinable(int number);
  int FindOrMakePlane(
    const std::vector<int>& returns, const lms3dFittedPlane& fit, std::size_t planesBefore);
  void AddReturns(PatchesOfPlanes& patches, std::vector<char>& isExplained);
  void AddLoose(const PatchesOfPlanes& patches, std::vector<char>& isExplained);
  void GuessTriangles(const std::vector<int>& planeOfPatch);
  void AcceptGuesses(const std::vector<int>& planeOfPatch);
  int FindPlane(const std::vector<int>& returns, const lms3dFittedPlane& fit) const;
  /// Curved planes do not explain a flat patch.
  bool IsMostlyExplained(
    const std::vector<lms3dMappedReturn>& returns, std::size_t end, bool isFlat) const;

  const lms3dLocalMap& Local;
  const lms3dSeenRanges& Ranges;
  lms3dFusedPlanes& Planes;
  /// The planes that a patch may join, in order.
  std::vector<int> Joinable;
  /// Their frames.
  std::vector<lms3dPlaneFrame> Frames;
};

#endif
