// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The borders of patches, from junction to junction.
 */
#ifndef lms3dBorderChains_h
#define lms3dBorderChains_h

#include "LocalMap/Borders/lms3dBorderGates.h"

#include <cstdint>
#include <vector>

/**
 * A chain is a row of edges between two junctions, or all around. Where no cut keeps two patches
 * apart, they share it, and its edges are those of one side. Junctions lie where more than two
 * patches or kinds of border meet in a cell.
 */
class lms3dBorderChains
{
public:
  struct Chain
  {
    std::vector<int> Edges;
    bool IsClosed;
  };

  /// Keeps a reference.
  explicit lms3dBorderChains(const lms3dBorderGates& gates);

  const std::vector<Chain>& GetChains() const { return this->Chains; }

  /// The edge before an edge of the same patch's border.
  int GetBefore(int edge) const { return this->Before[edge]; }

  /// For an edge that begins a side of a chain twice the chain's number, plus 1 for the other side;
  /// below 0 for others.
  std::int32_t GetChainOf(int edge) const { return this->ChainOf[edge]; }

private:
  void FindChains();
  void AddChain(int first, std::vector<bool>& visited);
  bool IsStart(int edge) const;

  const lms3dBorderGates& Gates;
  std::vector<Chain> Chains;
  std::vector<std::int32_t> Before;
  std::vector<std::int32_t> ChainOf;
};

#endif
