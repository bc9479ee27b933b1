// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves vertices of a map, one after the other, to the ranges that fit the returns best.
 */
#ifndef lms3dVertexFits_h
#define lms3dVertexFits_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <cstdint>
#include <vector>

/**
 * Each chosen vertex gets the range that fits the returns around it best (lms3dVertexFit), while
 * its neighbours stay. Each return around it stays within the bound. A vertex whose range the
 * returns do not determine stays.
 *
 * Vertices are fitted in the order of their numbers, each to the new ranges of those before it.
 * Vertices without a chosen neighbour left before them are fitted at the same time, so the result
 * does not depend on the number of threads.
 */
class lms3dVertexFits
{
public:
  /// `isChosen` is 1 for the vertices to fit, by vertex. Uses the threads of the calling TBB arena.
  static void Run(const lms3dBeamDemands& demands, const std::vector<std::uint8_t>& isChosen,
    lms3dVertexStars& stars);

private:
  static std::vector<std::vector<std::int32_t>> FindLevels(
    const lms3dVertexStars& stars, const std::vector<std::uint8_t>& isChosen);
  static void FitOne(const lms3dBeamDemands& demands, std::int32_t vertex, lms3dVertexStars& stars);
};

#endif
