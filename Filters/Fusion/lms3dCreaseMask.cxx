// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dCreaseMask.h"

#include "Fusion/lms3dRasterRows.h"

#include <bitset>

namespace
{
// Cells: how far a crease reaches beyond its parts.
constexpr double ReachAlong = 12.0;
// Cells: returns nearer to a crease may be of the other plane.
constexpr double ReachAcross = 8.0;
} // namespace

void lms3dCreaseMask::Draw(const lms3dCreaseLine& crease, lms3dRaster& raster)
{
  this->Blocks.resize(static_cast<std::size_t>(raster.GetNumberOfBlocks()));
  for (const auto& [first, last] : crease.Parts.Drawn)
  {
    for (const double width : { 0.0, ReachAcross })
    {
      Rectangle corners = {};
      for (int i = 0; i < 4; ++i)
      {
        const double along = i == 0 || i == 3 ? first - ReachAlong : last + ReachAlong;
        const double across = i < 2 ? -width : width;
        corners[i] = { crease.Point[0] + along * crease.Direction[0] - across * crease.Direction[1],
          crease.Point[1] + along * crease.Direction[1] + across * crease.Direction[0] };
      }
      this->Draw(width > 0.0 ? &Cells::Near : &Cells::Line, corners, raster);
    }
  }
}

void lms3dCreaseMask::Draw(BitsOf bits, const Rectangle& corners, lms3dRaster& raster)
{
  lms3dForTouchedStrips(corners,
    [&](const lms3dCellStrip& strip)
    {
      for (std::int32_t u = lms3dRaster::GetBlockOf(strip.Left);
           !strip.IsEmpty() && u <= lms3dRaster::GetBlockOf(strip.Right); ++u)
      {
        this->Draw(bits, strip, u, raster);
      }
      return true;
    });
}

void lms3dCreaseMask::Draw(
  BitsOf bits, const lms3dCellStrip& strip, std::int32_t u, lms3dRaster& raster)
{
  const int number = raster.Find(u, lms3dRaster::GetBlockOf(strip.Row));
  if (number < 0)
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
