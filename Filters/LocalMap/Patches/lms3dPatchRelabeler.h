// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Refines which returns belong to which patch where patches meet.
 */
#ifndef lms3dPatchRelabeler_h
#define lms3dPatchRelabeler_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <cstdint>
#include <vector>

/// Changes the labels of returns at the borders of patches. The planes stay as they are.
class lms3dPatchRelabeler
{
public:
  /// Keeps references. `maximumError` is the error bound of the map, metres along the beam, and
  /// `noise` the standard deviation of ranges, metres.
  lms3dPatchRelabeler(
    const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise);

  /// Moves each return at a border to the joined patch that explains it best: if both planes do,
  /// the patch on whose side of their crease the return lies, otherwise the patch of the nearer
  /// plane. Uses the threads of the calling TBB arena.
  void RelabelBorders();

  /**
   * Moves patches of a few returns to the large patch around them if its plane is near enough. The
   * mesh of the large patch then rises to these returns, which takes fewer triangles than a border
   * around them. Uses the threads of the calling TBB arena.
   */
  void AbsorbSpikes();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  std::vector<GridIndex> FindBorder() const;
  bool MoveToBestNeighbor(GridIndex index);
  bool IsBetter(GridIndex index, std::int32_t label, std::int32_t than) const;
  double GetDeviation(GridIndex index, int patch) const;
  void SetLabel(GridIndex index, std::int32_t label);
  std::vector<std::vector<GridIndex>> FindSpikes() const;
  int FindSurroundingPatch(const std::vector<GridIndex>& members) const;

  /// Calls visit(neighbour) for each neighbour that lies on one surface with an entry.
  template <typename Visitor>
  void ForEachJoinedNeighbor(GridIndex index, const Visitor& visit) const
  {
    for (int side = lms3dBeamSphere::Up; side <= lms3dBeamSphere::Left; ++side)
    {
      if (this->Sphere.HasNeighbor(index, side) && this->Sphere.IsJoined(index, side))
      {
        visit(this->Sphere.GetNeighbor(index, side));
      }
    }
  }

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const double MaximumError;
  const double Noise;
};

#endif
