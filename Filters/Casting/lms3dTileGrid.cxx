// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTileGrid.h"

#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>

namespace
{
// Degrees.
constexpr double MaximumBlockAngle = 90.0;

// Covers the rounding of a cosine to single precision.
constexpr double CosineMargin = 1.0 - 1e-6;

int CountBlocks(int turnsOrBeams)
{
  return (turnsOrBeams - 1) / lms3dTileGrid::BlockSide + 1;
}
} // namespace

lms3dTileGrid::lms3dTileGrid(const lms3dBeamGrid& grid)
  : Grid(grid)
  , BlocksPerTurn(CountBlocks(grid.Beams))
  , NumberOfBlocks(CountBlocks(grid.Turns) * this->BlocksPerTurn)
{
  for (int level = 0; level < 3; ++level)
  {
    const double angle = (Area{ level, 0, 0 }.GetSide() - 1) * grid.TurnStep;
    this->HalfCosines[level] =
      static_cast<float>(std::cos(0.5 * angle * lms3dRadiansPerDegree) * CosineMargin);
  }
}

bool lms3dTileGrid::CanDivide(const lms3dBeamGrid& grid)
{
  return grid.TurnStep * BlockSide <= MaximumBlockAngle;
}

lms3dTileGrid::Area lms3dTileGrid::GetBlock(int block) const
{
  return { 0, block / this->BlocksPerTurn * BlockSide, block % this->BlocksPerTurn * BlockSide };
}

int lms3dTileGrid::FindBlock(int turn, int beam) const
{
  return turn / BlockSide * this->BlocksPerTurn + beam / BlockSide;
}

void lms3dTileGrid::FillTile(const Area& area, int i, lms3dTiles& tiles) const
{
  const int lastTurn = this->Grid.Turns - 1;
  const int lastBeam = this->Grid.Beams - 1;
  const int turns[2] = { std::min(area.Turn, lastTurn),
    std::min(area.Turn + area.GetSide() - 1, lastTurn) };
  const int beams[2] = { std::min(area.Beam, lastBeam),
    std::min(area.Beam + area.GetSide() - 1, lastBeam) };
  for (int end = 0; end < 2; ++end)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      tiles.Fan[end][axis][i] = static_cast<float>(this->Grid.FanAxes[turns[end]][axis]);
    }
    tiles.Cosine[end][i] = static_cast<float>(this->Grid.Cosines[beams[end]]);
    const float sine = static_cast<float>(this->Grid.Sines[beams[end]]);
    const bool isTowardsHorizon = end == 0 ? sine > 0.0f : sine < 0.0f;
    tiles.Sine[end][i] = isTowardsHorizon ? sine * this->HalfCosines[area.Level] : sine;
  }
}

std::uint32_t lms3dTileGrid::FillParts(const Area& area, lms3dTiles& tiles) const
{
  std::uint32_t present = 0;
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    const Area part = area.GetPart(i);
    this->FillTile(part, i, tiles);
    const bool isPresent = part.Turn < this->Grid.Turns && part.Beam < this->Grid.Beams;
    present |= isPresent ? 1u << i : 0u;
  }
  this->FillCorners(tiles);
  return present;
}

void lms3dTileGrid::FillGroup(int group, lms3dTiles& tiles) const
{
  const int first = group * lms3dTiles::Size;
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    this->FillTile(this->GetBlock(std::min(first + i, this->NumberOfBlocks - 1)), i, tiles);
  }
  this->FillCorners(tiles);
}

std::uint32_t lms3dTileGrid::GetBlocksOfGroup(int group) const
{
  const int blocks = this->NumberOfBlocks - group * lms3dTiles::Size;
  return (1u << std::min(lms3dTiles::Size, blocks)) - 1u;
}

void lms3dTileGrid::FillCorners(lms3dTiles& tiles) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    tiles.Up[axis] = static_cast<float>(this->Grid.Up[axis]);
  }
  this->Kernels.FillTileCorners(tiles);
}
