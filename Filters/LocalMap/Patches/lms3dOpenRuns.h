// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the flood of a patch goes on beside a span.
 */
#ifndef lms3dOpenRuns_h
#define lms3dOpenRuns_h

#include "LocalMap/Patches/lms3dLabelChanges.h"

#include <algorithm>
#include <cstdint>
#include <vector>

/// Entries of a column of lms3dBeamSphere, beside a span. At *open* entries, the flood can go on. A
/// run is a longest sequence of open entries in which each is joined with the next one.
class lms3dOpenRuns
{
public:
  /// `rows` is the largest number of entries.
  explicit lms3dOpenRuns(int rows)
    : IsOpen(rows + 1)
    , IsEnd(rows)
  {
  }

  /// By entry, from the lowest: 1 if it is open, 0 if not. To be written before ForEach().
  std::int32_t* GetOpen() { return this->IsOpen.data(); }

  /// Calls visit(first, last) for each run of `count` entries, the lowest first. The number of the
  /// lowest entry is 0. `joins` has the flags of each entry, as lms3dBeamSphere::GetJoins().
  template <typename Visitor>
  void ForEach(const std::uint8_t* joins, int count, const Visitor& visit)
  {
    this->MarkEnds(joins, count);
    const auto findEnd = [&](int from)
    { return lms3dLabelChanges::FindFirst(this->IsEnd.data(), from, count, 1); };
    const auto begin = this->IsOpen.begin();
    int next = 0;
    for (int end = findEnd(0); end < count; end = findEnd(next))
    {
      visit(static_cast<int>(std::find(begin + next, begin + end, 1) - begin), end);
      next = end + 1;
    }
  }

private:
  void MarkEnds(const std::uint8_t* joins, int count);

  /// One entry more, which is not open.
  std::vector<std::int32_t> IsOpen;
  /// 1 for the last entry of each run.
  std::vector<std::uint8_t> IsEnd;
};

#endif
