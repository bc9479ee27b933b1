// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dMeshedBlock.h"

#include <cstdint>

namespace
{
void SetCovered(const lms3dRegionBlock& cells, lms3dRasterBlock& block)
{
  const bool isAllCovered = lms3dAreAllSet(cells.Covered) && lms3dAreAllSet(cells.Touched);
  if (!block.IsAllCovered || !isAllCovered)
  {
    block.Covered = cells.Covered;
    block.Touched = cells.Touched;
    block.IsAllCovered = isAllCovered;
  }
}

bool HasFilled(const lms3dRegionBlock& cells, const lms3dRasterBlock& block)
{
  std::uint64_t filled = 0;
  for (int row = 0; row < lms3dRaster::Size && !block.IsShapeFull; ++row)
  {
    filled |= cells.May[row] & ~block.Shape[row];
  }
  return filled != 0;
}
} // namespace

void lms3dNoteMesh(const lms3dRegionBlock& cells, lms3dRasterBlock& block)
{
  SetCovered(cells, block);
  block.HasFilled = HasFilled(cells, block);
  if (!block.IsMeshedFull || !block.IsShapeFull)
  {
    block.Meshed = block.Shape;
    block.IsMeshedFull = block.IsShapeFull;
  }
  block.Difference = 0;
  block.DifferenceAtCreases = 0;
  block.NewCreaseCells = 0;
}
