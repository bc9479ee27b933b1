// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The straightened outlines of all patches, with vertices that neighbours share.
 */
#ifndef lms3dPatchOutlines_h
#define lms3dPatchOutlines_h

#include "LocalMap/Borders/lms3dBorderPaths.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Puts the borders of all patches together, so that the patches' meshes fit without cracks and
 * without T-junctions. If a strip along an offset would face away from the sensor, the borders near
 * it are made again under tighter rules (lms3dBorderJunctions::FallbackLevel).
 *
 * Vertices are numbered for the whole map, the junctions first. See lms3dBorderGates for the words.
 */
class lms3dPatchOutlines
{
public:
  /// The polygon of a patch, with holes: closed loops of vertices, the patch to the left of each.
  struct Outline
  {
    /// The loops one after the other.
    std::vector<std::int32_t> Vertices;
    /// The end of each loop in Vertices.
    std::vector<std::int32_t> LoopEnds;
  };

  /// Keeps references. Uses the threads of the calling TBB arena.
  lms3dPatchOutlines(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates);

  const std::vector<lms3dMapVertex>& GetVertices() const { return this->Vertices; }

  /// Empty for a patch without returns.
  const Outline& GetOutline(int patch) const { return this->Outlines[patch]; }

  /// The triangles of all strips along offsets (lms3dOffsetStrips). They face the sensor, except
  /// where GetPatchesAtFlippedStrips() says otherwise.
  const std::vector<std::array<std::int32_t, 3>>& GetStripTriangles() const
  {
    return this->StripTriangles;
  }

  /// The patches on both sides of strips that face away from the sensor even at the last fallback
  /// level.
  const std::vector<std::int32_t>& GetPatchesAtFlippedStrips() const
  {
    return this->PatchesAtFlippedStrips;
  }

  /// The returns beside the ends of these strips.
  const std::vector<lms3dBeamSphere::GridIndex>& GetReturnsAtFlippedStrips() const
  {
    return this->ReturnsAtFlippedStrips;
  }

private:
  using Chain = lms3dBorderChains::Chain;

  /// The numbers of a chain's vertices between its junctions, for its own side and for its other
  /// side in the same order. Only along offsets do the two differ.
  struct Line
  {
    std::vector<std::int32_t> Own;
    std::vector<std::int32_t> Other;
  };

  void StraightenChains();
  void NumberBends();
  void MakeLoops();
  void AppendSide(int edge, Outline& outline, int& next) const;
  bool MakeStrips();
  void AddFlippedStrip(const Chain& chain);
  std::vector<std::int32_t> GetWholeLine(std::size_t chain, int side) const;

  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dBorderRanges BorderRanges;
  const lms3dBorderChains Chains;
  lms3dBorderJunctions Junctions;
  const lms3dBorderPaths Paths;
  /// The vertices of each chain, as lms3dBorderPaths returns them, and their numbers.
  std::vector<std::vector<lms3dMapVertex>> Bends;
  std::vector<Line> Lines;
  std::vector<lms3dMapVertex> Vertices;
  std::vector<Outline> Outlines;
  std::vector<std::array<std::int32_t, 3>> StripTriangles;
  std::vector<std::int32_t> PatchesAtFlippedStrips;
  std::vector<lms3dBeamSphere::GridIndex> ReturnsAtFlippedStrips;
};

#endif
