// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dCreaseMask.h"

#include "Fusion/Cells/lms3dBox2.h"
#include "Fusion/Cells/lms3dRasterRows.h"

#include <algorithm>
#include <bitset>

namespace
{
// Cells: how far a crease reaches beyond its parts.
constexpr double ReachAlong = 12.0;
// Cells: returns nearer to a crease may be of the other plane.
constexpr double ReachAcross = 8.0;

using Rectangle = std::array<lms3dPoint2, 4>;

// The cells along a part of a crease.
Rectangle GetCorners(const lms3dCreaseLine& crease, double first, double last, double width)
{
  Rectangle corners = {};
  for (int i = 0; i < 4; ++i)
  {
    const double along = i == 0 || i == 3 ? first - ReachAlong : last + ReachAlong;
    const double across = i < 2 ? -width : width;
    corners[i] = { crease.Point[0] + along * crease.Direction[0] - across * crease.Direction[1],
      crease.Point[1] + along * crease.Direction[1] + across * crease.Direction[0] };
  }
  return corners;
}

// Whether two creases have the same cells.
bool LooksLike(const lms3dCreaseLine& a, const lms3dCreaseLine& b)
{
  return a.Point == b.Point && a.Direction == b.Direction && a.Parts.Drawn == b.Parts.Drawn;
}

// Whether a crease may have cells in a box.
bool MayReach(const lms3dCreaseLine& crease, const lms3dBox2& box)
{
  return std::any_of(crease.Parts.Drawn.begin(), crease.Parts.Drawn.end(),
    [&](const auto& part)
    {
      lms3dBox2 cells;
      for (const lms3dPoint2& corner : GetCorners(crease, part.first, part.second, ReachAcross))
      {
        cells.Add(corner);
      }
      return cells.IsNear(box, 1.0);
    });
}

lms3dBox2 GetBoxOfBlocks(int first, const lms3dRaster& raster)
{
  lms3dBox2 box;
  for (int number = first; number < raster.GetNumberOfBlocks(); ++number)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    for (const int corner : { 0, 1 })
    {
      box.Add({ static_cast<double>(lms3dRaster::Size) * (block.U + corner),
        static_cast<double>(lms3dRaster::Size) * (block.V + corner) });
    }
  }
  return box;
}
} // namespace

void lms3dCreaseMask::Draw(const std::vector<lms3dCreaseLine>& creases, lms3dRaster& raster)
{
  if (creases.empty())
  {
    return;
  }
  const auto before = static_cast<int>(this->Blocks.size());
  this->Blocks.resize(static_cast<std::size_t>(raster.GetNumberOfBlocks()));
  const lms3dBox2 newBlocks = GetBoxOfBlocks(before, raster);
  std::vector<lms3dCreaseLine> drawnNow;
  for (const lms3dCreaseLine& crease : creases)
  {
    const bool isDrawn = std::any_of(this->Drawn.begin(), this->Drawn.end(),
      [&](const lms3dCreaseLine& drawn) { return LooksLike(drawn, crease); });
    if (!isDrawn || MayReach(crease, newBlocks))
    {
      this->Draw(crease, isDrawn ? before : 0, raster);
    }
    drawnNow.push_back({ crease.Point, crease.Direction, { {}, crease.Parts.Drawn } });
  }
  this->Drawn.swap(drawnNow);
}

void lms3dCreaseMask::Draw(const lms3dCreaseLine& crease, int firstBlock, lms3dRaster& raster)
{
  for (const auto& [first, last] : crease.Parts.Drawn)
  {
    for (const double width : { 0.0, ReachAcross })
    {
      this->Draw(width > 0.0 ? &Cells::Near : &Cells::Line, GetCorners(crease, first, last, width),
        firstBlock, raster);
    }
  }
}

void lms3dCreaseMask::Draw(
  BitsOf bits, const Rectangle& corners, int firstBlock, lms3dRaster& raster)
{
  lms3dForTouchedStrips(corners,
    [&](const lms3dCellStrip& strip)
    {
      for (std::int32_t u = lms3dRaster::GetBlockOf(strip.Left);
           !strip.IsEmpty() && u <= lms3dRaster::GetBlockOf(strip.Right); ++u)
      {
        this->Draw(bits, strip, u, firstBlock, raster);
      }
      return true;
    });
}

void lms3dCreaseMask::Draw(
  BitsOf bits, const lms3dCellStrip& strip, std::int32_t u, int firstBlock, lms3dRaster& raster)
{
  const int number = raster.Find(u, lms3dRaster::GetBlockOf(strip.Row));
  if (number < firstBlock)
  {
    return;
  }
  std::unique_ptr<Cells>& cells = this->Blocks[number];
  if (!cells)
  {
    cells = std::make_unique<Cells>();
  }
  std::uint64_t* const words = &((*cells).*bits)[lms3dRaster::GetPlaceOf(strip.Row)];
  std::size_t count = 0;
  for (int row = 0; row < strip.Count; ++row)
  {
    const std::uint64_t mask = strip.GetBits(row, u * lms3dRaster::Size);
    count += std::bitset<lms3dRaster::Size>(mask & ~words[row]).count();
    words[row] |= mask;
  }
  if (count > 0)
  {
    raster.SetMark(number, lms3dRaster::DIRTY);
    raster.GetBlock(number).NewCreaseCells += static_cast<int>(count);
  }
}
