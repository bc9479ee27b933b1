// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The junctions at which border chains end, and which patches share a vertex there.
 */
#ifndef lms3dBorderJunctions_h
#define lms3dBorderJunctions_h

#include "LocalMap/Borders/lms3dBorderChains.h"
#include "LocalMap/Borders/lms3dJunctionPlacement.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

/**
 * A junction is a cell and some of the cell's corners (see the figure in lms3dBorderGates.h): all
 * corners that neither a depth step nor an offset separates. The patches of these corners share one
 * vertex, whose number is the number of the junction. A cell can hold up to four junctions.
 */
class lms3dBorderJunctions
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Chain = lms3dBorderChains::Chain;

  /// What a cell gives up, level by level, while a strip that ends in it would flip.
  enum FallbackLevel
  {
    /// The junctions of the cell stay in its middle.
    JunctionsStay = 1,
    /// The chains that end in the cell have a vertex in each gate.
    PathsBendInEachGate = 2,
    MaximumFallback = PathsBendInEachGate
  };

  /// Keeps references. Uses the threads of the calling TBB arena.
  lms3dBorderJunctions(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
    const lms3dBorderGates& gates, const lms3dBorderChains& chains,
    const lms3dBorderRanges& borderRanges);

  std::int32_t GetNumberOfJunctions() const
  {
    return static_cast<std::int32_t>(this->Junctions.size());
  }

  /// Locates all junctions if `vertices` is empty, otherwise again the junctions of cells with a
  /// fallback. Then the vertices are the vertices of all junctions, in order. Uses the threads of
  /// the calling TBB arena.
  void Locate(std::vector<lms3dMapVertex>& vertices) const;

  ///@{
  /// The junction at the start or end of a chain that is not closed. `side` is 0 for the chain's
  /// own side, 1 for its other side. Only along offsets do the two differ.
  std::int32_t GetStart(std::size_t chain, int side) const { return this->Ends[chain][side]; }
  std::int32_t GetEnd(std::size_t chain, int side) const { return this->Ends[chain][2 + side]; }
  ///@}

  /// Whether a depth step ends at the start (`end` 0) or end (`end` 1) of a chain, inside a surface
  /// that is whole around it: the end of a slit.
  bool IsEndOfSlit(std::size_t chain, int end) const;

  /// Whether a chain along a depth step needs a vertex between its junctions. Without one, it could
  /// coincide with the border of the patch beyond a slit.
  bool NeedsBendAtSlit(std::size_t chain) const;

  /// The junctions around the hole that the strips of offsets leave in a cell, counter-clockwise.
  /// Empty if a depth step passes the cell. `first` is the first junction of the cell.
  std::vector<std::int32_t> GetHole(std::int32_t first) const;
  bool IsFirstOfCell(std::int32_t junction) const;

  /// Raises the fallback level of the cells at both ends of a chain by one.
  void RaiseFallback(const Chain& chain);
  /// Whether the cell at either end of a chain has reached a fallback level.
  bool HasFallback(const Chain& chain, int level) const;

private:
  using Cell = lms3dBorderGates::Cell;

  struct Junction
  {
    /// The lower left corner, which identifies the cell.
    GridIndex LowerLeft;
    /// The corners of the cell whose patches share the vertex, as bits.
    std::uint8_t Corners;

    bool operator<(const Junction& other) const
    {
      return this->LowerLeft != other.LowerLeft ? this->LowerLeft < other.LowerLeft
                                                : this->Corners < other.Corners;
    }
  };

  void FindJunctions();
  std::array<Junction, 4> GetEndJunctions(std::size_t chain) const;
  Junction GetEndJunction(int edge) const;
  std::uint8_t GetGroup(const Cell& cell, int own) const;
  GridIndex GetEndCell(const Chain& chain, int end) const;
  bool HasFallback(GridIndex cell, int level) const;
  std::vector<std::int32_t> GetOthers(const Junction& junction, std::int32_t own) const;

  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dBorderChains& Chains;
  const lms3dJunctionPlacement Placement;
  std::vector<Junction> Junctions;
  /// The junctions of each chain: at the start for both sides, then at the end for both sides.
  std::vector<std::array<std::int32_t, 4>> Ends;
  /// By the lower left corner of the cell.
  std::map<GridIndex, int> Fallbacks;
};

#endif
