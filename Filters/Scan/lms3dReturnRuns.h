// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which beams of a turn gave a return, as a list or as runs of neighbours.
 *
 * `triangles` has one value for each beam of the turn, lms3dBeamPacket::NoTriangle if it gave no
 * return.
 */
#ifndef lms3dReturnRuns_h
#define lms3dReturnRuns_h

#include "Kernels/lms3dBeamPacket.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Some returns of one turn, and the slot of the first.
struct lms3dReturnPiece
{
  int Turn;
  int Count;
  std::size_t Slot;
};

/// The returns of neighbouring beams, between beams without one.
struct lms3dReturnRun
{
  lms3dReturnPiece Returns;
  int FirstBeam;
};

inline int lms3dCountRuns(const std::int32_t* triangles, int beams)
{
  // Compilers vectorize a count that is as wide as the elements.
  std::int32_t runs = triangles[0] != lms3dBeamPacket::NoTriangle ? 1 : 0;
  for (int beam = 1; beam < beams; ++beam)
  {
    const bool isFirst = (triangles[beam] != lms3dBeamPacket::NoTriangle) &
      (triangles[beam - 1] == lms3dBeamPacket::NoTriangle);
    runs += isFirst ? 1 : 0;
  }
  return runs;
}

/// Appends the runs of a turn, whose returns begin at `returns.Slot`.
inline void lms3dFindRuns(const std::int32_t* triangles, int beams, lms3dReturnPiece returns,
  std::vector<lms3dReturnRun>& runs)
{
  const std::int32_t* end = triangles + beams;
  const auto isReturn = [](std::int32_t triangle)
  { return triangle != lms3dBeamPacket::NoTriangle; };
  for (const std::int32_t* first = std::find_if(triangles, end, isReturn); first != end;)
  {
    const std::int32_t* last = std::find_if_not(first, end, isReturn);
    returns.Count = static_cast<int>(last - first);
    runs.push_back({ returns, static_cast<int>(first - triangles) });
    returns.Slot += returns.Count;
    first = std::find_if(last, end, isReturn);
  }
}

/// Returns the beams of a turn that gave a return.
inline std::vector<int> lms3dFindHits(const std::int32_t* triangles, int beams)
{
  std::vector<int> hits(beams);
  int found = 0;
  for (int beam = 0; beam < beams; ++beam)
  {
    hits[found] = beam;
    found += triangles[beam] != lms3dBeamPacket::NoTriangle ? 1 : 0;
  }
  hits.resize(found);
  return hits;
}

#endif
