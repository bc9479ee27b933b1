// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Groups of blocks of a plane that lie beside one another.
 */
#ifndef lms3dBlockGroups_h
#define lms3dBlockGroups_h

#include "Fusion/Cells/lms3dBlockIndex.h"
#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Planes/lms3dPlaneFrame.h"

#include <algorithm>
#include <cstdint>
#include <vector>

/// The first and the last blocks along both axes.
struct lms3dBlockGroup
{
  void Add(std::int32_t u, std::int32_t v)
  {
    this->Left = std::min(this->Left, u);
    this->Right = std::max(this->Right, u);
    this->Bottom = std::min(this->Bottom, v);
    this->Top = std::max(this->Top, v);
  }

  /// World coordinates, metres.
  lms3dVector GetCentre(const lms3dPlaneFrame& frame) const
  {
    return frame.ToWorld({ 0.5 * lms3dRaster::Size * (this->Left + this->Right + 1),
      0.5 * lms3dRaster::Size * (this->Bottom + this->Top + 1) });
  }

  /// More than the distance of a corner from the centre, metres.
  double GetRadius(const lms3dPlaneFrame& frame) const;

  std::int32_t Left;
  std::int32_t Right;
  std::int32_t Bottom;
  std::int32_t Top;
};

/// A group lies in a square of 2 x 2 blocks. So a search for what is near goes through fewer places
/// than blocks, and reads nothing of the blocks.
class lms3dBlockGroups
{
public:
  lms3dBlockGroups() = default;

  /// Blocks before the first one are in no group.
  lms3dBlockGroups(const lms3dRaster& raster, int firstBlock)
    : FirstBlock(firstBlock)
    , EndOfBlocks(firstBlock)
  {
    this->Update(raster);
  }

  /// Adds new blocks to groups.
  void Update(const lms3dRaster& raster);

  int GetFirstBlock() const { return this->FirstBlock; }
  const std::vector<lms3dBlockGroup>& Get() const { return this->Groups; }
  /// The first and the last blocks of all groups.
  const lms3dBlockGroup& GetAll() const { return this->All; }

private:
  int FirstBlock = 0;
  /// The blocks before this one are in groups.
  int EndOfBlocks = 0;
  std::vector<lms3dBlockGroup> Groups;
  lms3dBlockGroup All = { 0, -1, 0, -1 };
  lms3dBlockIndex Numbers;
};

#endif
