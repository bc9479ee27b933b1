// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dBlockGroups.h"

#include <cmath>

namespace
{
// Blocks along a side of a square are 2 to this power.
constexpr int Shift = 1;
// Cells: more than the rounding of a corner.
constexpr double Margin = 0.005;
} // namespace

double lms3dBlockGroup::GetRadius(const lms3dPlaneFrame& frame) const
{
  const double diagonal = std::hypot(this->Right - this->Left + 1, this->Top - this->Bottom + 1);
  return (0.5 * lms3dRaster::Size * diagonal + Margin) * frame.GetCell();
}

void lms3dBlockGroups::Update(const lms3dRaster& raster)
{
  for (; this->EndOfBlocks < raster.GetNumberOfBlocks(); ++this->EndOfBlocks)
  {
    const lms3dRasterBlock& block = raster.GetBlock(this->EndOfBlocks);
    if (this->Groups.empty())
    {
      this->All = { block.U, block.U, block.V, block.V };
    }
    this->All.Add(block.U, block.V);
    const int number = this->Numbers.Find(block.U >> Shift, block.V >> Shift);
    if (number < 0)
    {
      this->Numbers.Add(block.U >> Shift, block.V >> Shift, static_cast<int>(this->Groups.size()));
      this->Groups.push_back({ block.U, block.U, block.V, block.V });
      continue;
    }
    this->Groups[number].Add(block.U, block.V);
  }
}
