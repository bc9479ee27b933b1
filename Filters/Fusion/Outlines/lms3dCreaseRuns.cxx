// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dCreaseRuns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Cells: how far the border follows a crease at least, and how far if it comes back to a crease
// behind a gap that is not large.
constexpr double ShortestRun = 48.0;
constexpr double ShortestRunAmongOthers = 400.0;
constexpr double LargestGap = 48.0;

/// Successive corners that moved to creases. Numbers go on behind the last corner.
struct Run
{
  std::size_t First;
  std::size_t End;
  /// The largest distance from the first corner, cells.
  double Length;
};

double GetDistance(
  const std::vector<lms3dSnappedCorner>& corners, std::size_t first, std::size_t second)
{
  const lms3dPoint2& a = corners[first % corners.size()].Point;
  const lms3dPoint2& b = corners[second % corners.size()].Point;
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

// Returns none if all corners moved.
std::vector<Run> FindRuns(const std::vector<lms3dSnappedCorner>& corners)
{
  const std::size_t count = corners.size();
  const auto isMoved = [&](std::size_t i) { return corners[i % count].IsMoved; };
  std::size_t start = 0;
  while (start < count && isMoved(start))
  {
    ++start;
  }
  std::vector<Run> runs;
  for (std::size_t i = start; start < count && i < start + count; ++i)
  {
    if (!isMoved(i))
    {
      continue;
    }
    Run run = { i, i, 0.0 };
    for (; isMoved(run.End); ++run.End)
    {
      run.Length = std::max(run.Length, GetDistance(corners, i, run.End));
    }
    runs.push_back(run);
    i = run.End;
  }
  return runs;
}
} // namespace

void lms3dFreeShortRuns(std::vector<lms3dSnappedCorner>& corners)
{
  const std::vector<Run> runs = FindRuns(corners);
  const std::size_t count = runs.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Run& run = runs[i];
    const Run& before = runs[(i + count - 1) % count];
    const Run& behind = runs[(i + 1) % count];
    const bool isAmongOthers = count > 1 &&
      (GetDistance(corners, before.End - 1, run.First) < LargestGap ||
        GetDistance(corners, run.End - 1, behind.First) < LargestGap);
    const bool stays = run.Length >= (isAmongOthers ? ShortestRunAmongOthers : ShortestRun);
    for (std::size_t corner = run.First; corner < run.End; ++corner)
    {
      corners[corner % corners.size()].IsMoved = stays;
    }
  }
}
