// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One state of the map of many scans, and its changes since another state.
 */
#ifndef lms3dFusedMapState_h
#define lms3dFusedMapState_h

#include "LMS3DScanner.hh"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// A region of the map, as LMS3DScanner.idl defines it. It does not change after it is made.
struct lms3dFusedRegion
{
  std::uint32_t Id = 0;
  /// x, y, z of each point, metres, relative to the origin of the map.
  std::vector<float> Points;
  /// Three indices of the region's points for each triangle. Empty if the region is removed.
  std::vector<std::uint32_t> Triangles;
  /// Square metres.
  double Area = 0.0;
  /// The state that brought the region as it is.
  std::uint64_t Changed = 0;

  bool IsRemoved() const { return this->Triangles.empty(); }
  std::size_t GetBytes() const
  {
    return sizeof(*this) + sizeof(float) * this->Points.size() +
      sizeof(std::uint32_t) * this->Triangles.size();
  }
};

/// In increasing order of their ids.
using lms3dFusedRegions = std::vector<std::shared_ptr<const lms3dFusedRegion>>;

/// States share the regions that did not change between them. A state does not change after it is
/// published.
struct lms3dFusedMapState
{
  /// For this many states, a removed region is remembered. A client that is farther behind gets the
  /// whole map.
  static constexpr std::uint64_t Memory = 256;

  /// Without what describes the changes since another state, and without the problem.
  LMS3D::FusedMapHeader Header{};
  /// The regions of the map, and those that were removed from it.
  lms3dFusedRegions Regions;

  /// Whether the changes since the state `since` are the whole map.
  bool IsWhole(std::uint64_t since) const;

  /// The regions of getFusedMap().
  lms3dFusedRegions GetChanges(std::uint64_t since) const;

  /// The memory that this state does not share with the one before.
  std::size_t GetBytes() const;
};

using lms3dFusedMapPointer = std::shared_ptr<const lms3dFusedMapState>;

#endif
