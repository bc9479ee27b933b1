// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes all patches of a scan and puts the meshes together.
 */
#ifndef lms3dPatchSetMesher_h
#define lms3dPatchSetMesher_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dKeptMeshes.h"
#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include <vector>

/**
 * Traces the borders of a set of patches, meshes each patch, and puts the meshes together to a map.
 * If patches fail, splits them instead, so that the caller can try again.
 */
class lms3dPatchSetMesher
{
public:
  /// Keeps a reference. `maximumError` is the bound and `noise` the standard deviation of ranges,
  /// metres.
  lms3dPatchSetMesher(const lms3dBeamSphere& sphere, double maximumError, double noise)
    : Sphere(sphere)
    , MaximumError(maximumError)
    , Noise(noise)
  {
  }

  /**
   * Adds the triangles of all patches to an empty map and returns true, or splits the patches that
   * failed and returns false. `members` is the number of returns of each patch. Uses the threads of
   * the calling TBB arena.
   *
   * A patch that failed becomes patches of one return each. A patch of one return loses it; the
   * return then has the label lms3dPatches::None. So does a filled entry of the sphere at once. If
   * `releasesFew`, a large patch is divided into four parts instead; if only few returns of a patch
   * were uncovered, only these leave the patch; and the return of a patch of one moves to a patch
   * beside it first (lms3dDivideFailedPatches()). If beams are not regular and `releasesFew`, only
   * the returns beside a fault leave their patches (lms3dPatchSplitter); otherwise patches with
   * faults lose all their returns.
   *
   * The map has its LargestDeviation only if beams are not regular.
   */
  bool TryToMesh(
    lms3dPatches& patches, const std::vector<int>& members, bool releasesFew, lms3dBoundedMap& map);

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Meshes = std::vector<lms3dPatchMesh>;

  Meshes MakeMeshes(const lms3dPatches& patches, const lms3dPatchOutlines& outlines,
    const std::vector<int>& members);
  void Append(const lms3dPatchOutlines& outlines, const Meshes& meshes,
    const std::vector<int>& members, lms3dBoundedMap& map);
  bool SplitAtFaults(lms3dPatches& patches, const lms3dPatchOutlines& outlines,
    const std::vector<int>& members, bool isLenient, Meshes& meshes) const;
  static std::vector<lms3dRayCheck::Hit> CollectOthers(const Meshes& meshes);
  void Split(lms3dPatches& patches, const std::vector<int>& members,
    const std::vector<bool>& failed, const Meshes& meshes) const;
  void MakeSingle(lms3dPatches& patches, GridIndex index) const;

  const lms3dBeamSphere& Sphere;
  const double MaximumError;
  const double Noise;
  /// The meshes of the last attempt. None if beams are not regular.
  lms3dKeptMeshes Kept;
};

#endif
