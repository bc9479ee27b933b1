// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides which moves of a vertex into a neighbour keep the laws of a bounded map.
 */
#ifndef lms3dVertexMoves_h
#define lms3dVertexMoves_h

#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <cstdint>

/// The rules of lms3dVertexRemover. All functions may be called by several threads at a time.
class lms3dVertexMoves
{
public:
  virtual ~lms3dVertexMoves() = default;

  /// Whether the border of the surface from `last` over `middle` to `next`, with the surface to the
  /// left, may leave out `middle`.
  virtual bool MayLeaveBorder(const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle,
    std::int32_t next) const = 0;

  /// Whether the border of a patch along an offset may do the same.
  virtual bool MayLeaveOffset(const lms3dVertexStars& stars, std::int32_t last, std::int32_t middle,
    std::int32_t next) const = 0;

  /// Whether the returns around a vertex stay within the bound if it moves into a neighbour.
  virtual bool KeepsBound(
    const lms3dVertexStars& stars, std::int32_t from, std::int32_t to) const = 0;
};

#endif
