// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The vertices of a map that wait for a move, the cheapest first.
 */
#ifndef lms3dVertexQueue_h
#define lms3dVertexQueue_h

#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <cstdint>
#include <vector>

/// Stays sorted from round to round, so that a round looks only at the vertices that wait.
class lms3dVertexQueue
{
public:
  struct Entry
  {
    double Cost;
    std::int32_t Vertex;

    bool operator<(const Entry& other) const
    {
      return this->Cost != other.Cost ? this->Cost < other.Cost : this->Vertex < other.Vertex;
    }
  };

  /// Keeps a reference.
  explicit lms3dVertexQueue(const lms3dVertexStars& stars);

  /// Takes out vertices, then adds entries, in any order.
  void Update(const std::vector<std::int32_t>& removed, std::vector<Entry> added);

  /// Takes out vertices, the cheapest first, whose stars have no vertex in common.
  std::vector<std::int32_t> TakeIndependent();

private:
  bool TryToUse(std::int32_t vertex);

  const lms3dVertexStars& Stars;
  std::vector<Entry> Entries;
  /// By vertex: the number of the call that marked it last.
  std::vector<std::int32_t> Marks;
  std::int32_t Call = 0;
};

#endif
