// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dSmallHoles.h"

#include "Fusion/Cells/lms3dBox2.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace
{
// Cells along each axis.
constexpr double LargestHole = 32.0;

// Whether a loop goes around a hole that is small.
bool IsSmallHole(const lms3dLoop& loop)
{
  lms3dBox2 box;
  for (const lms3dPoint2& corner : loop)
  {
    box.Add(corner);
  }
  return box.High[0] - box.Low[0] <= LargestHole && box.High[1] - box.Low[1] <= LargestHole &&
    !lms3dIsAroundCells(loop);
}

// The cells in a loop along the axes, row by row.
std::vector<lms3dCellStrip> FindCells(const lms3dLoop& loop)
{
  const auto [lowest, highest] = std::minmax_element(loop.begin(), loop.end(),
    [](const lms3dPoint2& a, const lms3dPoint2& b) { return a[1] < b[1]; });
  const auto end = static_cast<std::int32_t>((*highest)[1]);
  std::vector<lms3dCellStrip> cells;
  for (auto row = static_cast<std::int32_t>((*lowest)[1]); row < end; ++row)
  {
    std::vector<std::int32_t> sides;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto [from, to] = std::minmax(loop[i][1], loop[(i + 1) % loop.size()][1]);
      if (from <= row && to > row)
      {
        sides.push_back(static_cast<std::int32_t>(loop[i][0]));
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    {
      cells.emplace_back();
      cells.back().Row = row;
      cells.back().Add(sides[i], sides[i + 1] - 1);
    }
  }
  return cells;
}

// Whether no beam passed through cells of a hole, they are not between beams that all passed, and
// no island lies in the hole.
bool IsFree(
  const std::vector<lms3dCellStrip>& cells, const lms3dRaster& raster, const lms3dRegion& region)
{
  return std::all_of(cells.begin(), cells.end(),
    [&](const lms3dCellStrip& strip)
    {
      return !region.HasAny(&lms3dRegionBlock::Passed, strip) &&
        !region.HasAny(&lms3dRegionBlock::May, strip) &&
        !raster.HasAny(&lms3dRasterBlock::Open, strip);
    });
}
} // namespace

void lms3dCloseSmallHoles(
  const lms3dRaster& raster, std::vector<lms3dLoop>& outlines, lms3dRegion& region)
{
  const auto close = [&](const lms3dLoop& loop)
  {
    if (!IsSmallHole(loop))
    {
      return false;
    }
    const std::vector<lms3dCellStrip> cells = FindCells(loop);
    const bool isFree = IsFree(cells, raster, region);
    for (std::size_t i = 0; isFree && i < cells.size(); ++i)
    {
      region.Set(&lms3dRegionBlock::May, cells[i], true);
    }
    return isFree;
  };
  outlines.erase(std::remove_if(outlines.begin(), outlines.end(), close), outlines.end());
}
