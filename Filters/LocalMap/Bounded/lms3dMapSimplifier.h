// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Removes the vertices of a bounded map that the bound does not need.
 */
#ifndef lms3dMapSimplifier_h
#define lms3dMapSimplifier_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"
#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <cstdint>
#include <vector>

class lms3dSmoothVertices;

/**
 * On curved surfaces, and with noise, patches are small, and most vertices lie at smooth borders
 * between them. Edges between smooth vertices (lms3dSmoothVertices) collapse (lms3dEdgeCollapser),
 * as long as each return around them stays within the bound. The remaining vertex has the range
 * that fits the returns best (lms3dVertexFit), so the surface passes between the returns on both
 * sides. Vertices at sharp creases, at borders and, unless the surface is curved, at offsets take
 * no part in this. Around collapsed edges, all vertices are then fitted to the returns
 * (lms3dSurfaceFit).
 *
 * Then vertices of all kinds are removed (lms3dVertexRemover) without moving those that remain. At
 * last, all vertices are fitted to the returns, edges are flipped so that the map fits better
 * (lms3dEdgeFlipper), and the vertices there are fitted again. On a curved surface, vertices are
 * removed and fitted, and edges flipped, a second time. If beams are not regular, vertices are only
 * removed, and borders stay (lms3dRayMoves).
 */
class lms3dMapSimplifier
{
public:
  /// Keeps references. `maximumError` is the bound and `noise` the standard deviation of
  /// ranges, metres.
  lms3dMapSimplifier(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError, double noise);

  /// Simplifies a map whose patches are the patches with returns, in order, and sets its
  /// LargestDeviation. Returns false, and changes nothing, if beams are not regular and no vertex
  /// can vanish. `members` is the number of returns of each patch. Uses the threads of the calling
  /// TBB arena.
  bool Simplify(const std::vector<int>& members, lms3dBoundedMap& map) const;

private:
  bool SimplifyOnRays(lms3dBoundedMap& map) const;
  void SimplifySmoothSurface(const lms3dSmoothVertices& smooth, const lms3dBeamDemands& demands,
    const lms3dBorderShortcuts& borders, lms3dVertexStars& stars) const;
  void FitSurface(const lms3dBeamDemands& demands, const lms3dBorderShortcuts& borders,
    const std::vector<std::int32_t>& patchIds, lms3dVertexStars& stars) const;
  static void Replace(const lms3dVertexStars& stars, lms3dBoundedMap& map);
  double GetLargestDeviation(const lms3dBoundedMap& map) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const double MaximumError;
  const double Noise;
};

#endif
