// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Merges patches that one plane explains, and settles where they meet.
 */
#ifndef lms3dPatchMerger_h
#define lms3dPatchMerger_h

#include "lms3dPatches.h"

#include <utility>
#include <vector>

class lms3dPatchMerger
{
public:
  /// `maximumError` is the bound of the whole map, metres along the beam; `noise` that of ranges.
  lms3dPatchMerger(
    const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise);

  /// Patches side by side become one where a plane of either, or of both, explains all returns.
  void Merge();

  /// Gives each return at a border to the patch on whose side of the crease it lies, or whose plane
  /// is nearest to it.
  void MoveBorders();

  /**
   * Gives patches of a few returns to a large one around them that is not too far off. The mesh of
   * that patch then rises to these returns, which takes fewer triangles than borders around them.
   */
  void TakeSpikes();

private:
  using Place = lms3dBeamSphere::Place;
  using Pair = std::pair<std::int32_t, std::int32_t>;

  std::vector<Pair> FindNeighbors() const;
  int FindRoot(int patch);
  bool TryToMerge(int large, int small);
  bool Explains(const lms3dPlane& plane, const lms3dPatches::Patch& patch) const;
  void Join(int large, int small, const lms3dPlane& plane);
  void WriteLabels();

  std::vector<Place> FindBorder() const;
  bool MoveToBestNeighbor(Place place);
  bool IsBetter(Place place, std::int32_t label, std::int32_t than) const;
  double GetDeviation(Place place, int patch) const;
  void SetLabel(Place place, std::int32_t label);
  int FindSurroundings(const std::vector<Place>& members) const;

  template <typename Visitor>
  void ForJoinedNeighbors(Place place, const Visitor& visit) const;

  const lms3dBeamSphere& Sphere;
  lms3dPatches& Patches;
  const double MaximumError;
  const double Noise;
  std::vector<int> Parents;
};

#endif
