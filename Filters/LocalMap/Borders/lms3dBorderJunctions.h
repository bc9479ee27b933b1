// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the borders of patches end, and which patches share a vertex there.
 */
#ifndef lms3dBorderJunctions_h
#define lms3dBorderJunctions_h

#include "LocalMap/Borders/lms3dBorderChains.h"
#include "LocalMap/Borders/lms3dBorderRanges.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

/**
 * Borders end in junctions, where more than two patches or kinds of border meet in a cell. All
 * patches around a junction that no cut and no step keeps apart share its vertex. A junction has the
 * number of its vertex.
 */
class lms3dBorderJunctions
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Chain = lms3dBorderChains::Chain;

  /// Keeps references.
  lms3dBorderJunctions(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
    const lms3dBorderGates& gates, const lms3dBorderChains& chains,
    const lms3dBorderRanges& borderRanges);

  std::int32_t GetNumberOfJunctions() const
  {
    return static_cast<std::int32_t>(this->Junctions.size());
  }

  /// A vertex for each junction.
  std::vector<lms3dMapVertex> Locate() const;

  /// Those of a chain that is not closed, by its number: of its own side (0) or the other (1).
  std::int32_t GetStart(std::size_t chain, int side) const { return this->Ends[chain][side]; }
  std::int32_t GetEnd(std::size_t chain, int side) const { return this->Ends[chain][2 + side]; }

  /// The cell at the start of a chain (0) or at its end (1).
  GridIndex GetEndCell(const Chain& chain, int end) const;

  /// Whether a chain runs along a cut from a junction that it shares with the other side (0), or to
  /// one (1): where a depth step ends within a surface, as a slit.
  bool IsEndOfSlit(std::size_t chain, int end) const;

  /// Whether a chain needs a bend of its own, lest it coincides with a border beyond a slit.
  bool NeedsBendAtSlit(std::size_t chain) const;

  /// The hole between the junctions of a cell where steps meet.
  std::vector<std::int32_t> GetHole(std::int32_t first) const;
  bool IsFirstOfCell(std::int32_t junction) const;

  /// How carefully a cell is to be treated: from 1 on its junctions stay in the middle.
  void RaiseFallback(GridIndex cell) { ++this->Fallbacks[cell]; }
  bool HasFallback(GridIndex cell, int level) const;

private:
  using Cell = lms3dBorderGates::Cell;

  /// The corners of a cell around which a junction's vertex is shared, as bits.
  struct Junction
  {
    std::int32_t LowerLeft;
    std::uint8_t Corners;

    bool operator<(const Junction& other) const
    {
      return this->LowerLeft != other.LowerLeft ? this->LowerLeft < other.LowerLeft
                                                : this->Corners < other.Corners;
    }
  };

  void FindJunctions();
  std::array<Junction, 4> GetEndJunctions(const Chain& chain) const;
  Junction GetEndJunction(int edge) const;
  std::uint8_t GetGroup(const Cell& cell, int own) const;
  bool IsOffset(const Cell& cell, int corner) const;
  bool IsWide(const Cell& cell) const;
  std::array<double, 4> SlideToCreases(const Junction& junction, const Cell& cell) const;
  std::array<double, 4> GetDifferences(const Cell& cell, int corner) const;
  std::vector<std::int32_t> GetOthers(const Junction& junction, std::int32_t own) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dBorderChains& Chains;
  const lms3dBorderRanges& BorderRanges;
  std::vector<Junction> Junctions;
  /// Of each chain the junctions at the start, of either side, and at the end.
  std::vector<std::array<std::int32_t, 4>> Ends;
  /// How often a band that ends in a cell has turned over.
  std::map<GridIndex, int> Fallbacks;
};

#endif
