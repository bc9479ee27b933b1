// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The straightened outlines of all patches, with vertices that neighbours share.
 */
#ifndef lms3dPatchOutlines_h
#define lms3dPatchOutlines_h

#include "LocalMap/Borders/lms3dBorderChains.h"
#include "LocalMap/Borders/lms3dBorderJunctions.h"
#include "LocalMap/Borders/lms3dBorderRanges.h"
#include "LocalMap/Borders/lms3dMinimumLinkPath.h"

#include <array>
#include <cstdint>
#include <vector>

class lms3dPatchOutlines
{
public:
  /// Loops of vertices, the patch to the left of each.
  struct Outline
  {
    std::vector<std::int32_t> Vertices;
    std::vector<std::int32_t> LoopEnds;
  };

  lms3dPatchOutlines(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates);

  const std::vector<lms3dMapVertex>& GetVertices() const { return this->Vertices; }
  const Outline& GetOutline(int patch) const { return this->Outlines[patch]; }

  /// The triangles of the bands and of the junctions of steps, facing the sensor.
  const std::vector<std::array<std::int32_t, 3>>& GetStripTriangles() const { return this->Strips; }

  /// Patches beside a band that would not face the sensor.
  const std::vector<std::int32_t>& GetPatchesAtFlippedStrips() const
  {
    return this->PatchesAtFlippedStrips;
  }

private:
  using Chain = lms3dBorderChains::Chain;

  /// The vertices within a chain, and those of its other side in the same order: the same numbers
  /// but along a step.
  struct Line
  {
    std::vector<std::int32_t> Own;
    std::vector<std::int32_t> Other;
  };

  void StraightenChains();
  void NumberBends();
  bool HasFallback(const Chain& chain) const;
  std::vector<lms3dMapVertex> Straighten(std::size_t number) const;
  std::vector<lms3dMinimumLinkPath::Vertex> FindBends(
    std::size_t number, const std::vector<lms3dMinimumLinkPath::Gate>& gates) const;
  std::vector<lms3dMinimumLinkPath::Gate> GetLineGates(const Chain& chain) const;
  void LimitExtension(int edge, lms3dMinimumLinkPath::Gate& gate) const;
  lms3dVector GetMiddle(std::int32_t a, std::int32_t b) const;
  void AppendVertices(int edge, double at, std::vector<lms3dMapVertex>& out) const;
  bool IsOffset(const Chain& chain) const;

  void MakeLoops();
  void AppendSide(int edge, Outline& outline, int& next) const;
  bool MakeStrips();
  std::vector<std::int32_t> GetWholeLine(std::size_t chain, int side) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dBorderRanges BorderRanges;
  const lms3dBorderChains Chains;
  lms3dBorderJunctions Junctions;
  /// Of each chain the vertices, along a step those of both sides in turn.
  std::vector<std::vector<lms3dMapVertex>> Bends;
  /// Their numbers.
  std::vector<Line> Lines;
  std::vector<lms3dMapVertex> Vertices;
  std::vector<Outline> Outlines;
  std::vector<std::array<std::int32_t, 3>> Strips;
  std::vector<std::int32_t> PatchesAtFlippedStrips;
};

#endif
