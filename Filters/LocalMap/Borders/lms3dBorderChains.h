// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The borders of patches, cut at junctions.
 */
#ifndef lms3dBorderChains_h
#define lms3dBorderChains_h

#include "LocalMap/Borders/lms3dBorderGates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * A chain is a sequence of edges (see the figure in lms3dBorderGates.h) from one junction to the
 * next, or all around a patch. At creases and offsets, both patches share one chain, made of the
 * edges of one side; the twins are its other side. At depth steps, each side has a chain of its
 * own.
 */
class lms3dBorderChains
{
public:
  struct Chain
  {
    /// In order, at least one, with the patch to the left.
    std::vector<int> Edges;
    /// Whether the last edge leads to the first one, without a junction.
    bool IsClosed;
  };

  /// Keeps a reference to the gates. Uses the threads of the calling TBB arena.
  explicit lms3dBorderChains(const lms3dBorderGates& gates);

  const std::vector<Chain>& GetChains() const { return this->Chains; }

  /// The kind of all gates of a chain.
  lms3dBorderGates::GateKind GetKind(std::size_t chain) const
  {
    return this->Gates.GetGate(this->Chains[chain].Edges.front()).Kind;
  }

  /// The edge whose GetNext() is this edge. The edge must not be void.
  int GetBefore(int edge) const { return this->Before[edge]; }

  /// If an edge begins a side of chain i: 2 i for the chain's own side, 2 i + 1 for its other side.
  /// Below 0 for all other edges.
  std::int32_t GetChainOf(int edge) const { return this->ChainOf[edge]; }

private:
  void FindChains();
  void FindStarts();
  void AddChain(int first);

  const lms3dBorderGates& Gates;
  std::vector<Chain> Chains;
  std::vector<std::int32_t> Before;
  std::vector<std::int32_t> ChainOf;
  ///@{
  /// By edge: whether it begins a chain that is not closed, and whether it belongs to a chain
  /// already, or is void.
  std::vector<std::uint8_t> IsStart;
  std::vector<std::uint8_t> IsVisited;
  ///@}
  /// Memory for the chain that is being made.
  std::vector<int> EdgesOfChain;
};

#endif
