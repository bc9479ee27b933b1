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

/// Returns the first beam that gave a return, or, if `isReturn` is false, the first that did not.
inline const std::int32_t* lms3dFindBeam(
  const std::int32_t* first, const std::int32_t* end, bool isReturn)
{
  // Compilers vectorize a count of fixed length, but no search.
  constexpr int Step = 16;
  for (; end - first >= Step; first += Step)
  {
    std::int32_t returns = 0;
    for (int i = 0; i < Step; ++i)
    {
      returns += first[i] != lms3dBeamPacket::NoTriangle ? 1 : 0;
    }
    if (returns != (isReturn ? 0 : Step))
    {
      break;
    }
  }
  return std::find_if(first, end,
    [isReturn](std::int32_t triangle)
    { return (triangle != lms3dBeamPacket::NoTriangle) == isReturn; });
}

/// Appends the runs of a turn, whose returns begin at `returns.Slot`. Returns false, and appends
/// none, if they are shorter than `minimumLength` on average.
inline bool lms3dFindRuns(const std::int32_t* triangles, int beams, lms3dReturnPiece returns,
  std::size_t minimumLength, std::vector<lms3dReturnRun>& runs)
{
  const std::size_t before = runs.size();
  const std::size_t maximumRuns = static_cast<std::size_t>(returns.Count) / minimumLength;
  const std::int32_t* end = triangles + beams;
  for (const std::int32_t* first = lms3dFindBeam(triangles, end, true); first != end;)
  {
    if (runs.size() - before == maximumRuns)
    {
      runs.resize(before);
      return false;
    }
    const std::int32_t* last = lms3dFindBeam(first, end, false);
    returns.Count = static_cast<int>(last - first);
    runs.push_back({ returns, static_cast<int>(first - triangles) });
    returns.Slot += returns.Count;
    first = lms3dFindBeam(last, end, true);
  }
  return true;
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
