// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tidies up where patches meet.
 */
#ifndef lms3dPatchBorders_h
#define lms3dPatchBorders_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <cstdint>
#include <vector>

class lms3dPatchRelabeler
{
public:
  /// `maximumError` is the bound of the whole map, metres along the beam; `noise` that of ranges.
  lms3dPatchRelabeler(
    const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise);

  /// Gives each return at a border to the patch on whose side of the crease it lies, or whose plane
  /// is nearest to it.
  void Move();

  /**
   * Gives patches of a few returns to a large one around them that is not too far off. The mesh of
   * that patch then rises to these returns, which takes fewer triangles than borders around them.
   */
  void TakeSpikes();

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  std::vector<GridIndex> FindBorder() const;
  bool MoveToBestNeighbor(GridIndex index);
  bool IsBetter(GridIndex index, std::int32_t label, std::int32_t than) const;
  double GetDeviation(GridIndex index, int patch) const;
  void SetLabel(GridIndex index, std::int32_t label);
  int FindSurroundings(const std::vector<GridIndex>& members) const;

  template <typename Visitor>
  void ForJoinedNeighbors(GridIndex index, const Visitor& visit) const;

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const double MaximumError;
  const double Noise;
};

#endif
