// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The grid of a scan's beams, divided into blocks, tiles and packets.
 */
#ifndef lms3dTileGrid_h
#define lms3dTileGrid_h

#include "Casting/lms3dBeamGrid.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

class lms3dTileGrid
{
public:
  ///@{
  /// Turns, and beams, of a block and of a tile. A block has 4 x 4 tiles, a tile 4 x 4 packets.
  static constexpr int PartsPerSide = 4;
  static constexpr int TileSide = PartsPerSide * lms3dBeamGrid::Side;
  static constexpr int BlockSide = PartsPerSide * TileSide;
  static_assert(PartsPerSide * PartsPerSide == lms3dTiles::Size);
  ///@}

  /// A square part of the grid, cut off at the grid's end. The level is 0 for a block, 1 for a tile
  /// and 2 for a packet.
  struct Area
  {
    int Level;
    int Turn;
    int Beam;

    int GetSide() const
    {
      constexpr int Sides[] = { BlockSide, TileSide, lms3dBeamGrid::Side };
      return Sides[this->Level];
    }

    /// Returns one of the parts of a block or tile, numbered by turn, then by beam.
    Area GetPart(int i) const
    {
      const int side = this->GetSide() / PartsPerSide;
      return { this->Level + 1, this->Turn + i / PartsPerSide * side,
        this->Beam + i % PartsPerSide * side };
    }
  };

  /// The arrays of the grid must outlive this object.
  explicit lms3dTileGrid(const lms3dBeamGrid& grid);

  /// Returns whether the turns of each block span 90 degrees at most. Wider blocks decide too
  /// little.
  static bool CanDivide(const lms3dBeamGrid& grid);

  const lms3dBeamGrid& GetBeams() const { return this->Grid; }
  int GetNumberOfBlocks() const { return this->NumberOfBlocks; }

  ///@{
  /// Returns a block, the number of the block that has a beam, and the number of the block's tile
  /// that has it. Blocks and tiles are numbered by turn, then by beam.
  Area GetBlock(int block) const;
  int FindBlock(int turn, int beam) const;
  static int FindPart(int turn, int beam)
  {
    return turn % BlockSide / TileSide * PartsPerSide + beam % BlockSide / TileSide;
  }
  ///@}

  /// Sets the input of FillTileCorners for tile `i`, from 0 to 15, to an area. An area that reaches
  /// beyond the grid ends with the grid's last turn or beam; one that lies beyond it is this turn
  /// or beam alone.
  void FillTile(const Area& area, int i, lms3dTiles& tiles) const;

  /// Fills all parts of an area with their corners and sides. Returns the parts that the grid has.
  std::uint32_t FillParts(const Area& area, lms3dTiles& tiles) const;

  /// Does the same for a group of sixteen successive blocks.
  void FillGroup(int group, lms3dTiles& tiles) const;

  /// Returns the blocks that the grid has in a group.
  std::uint32_t GetBlocksOfGroup(int group) const;

  int CountGroups() const { return (this->NumberOfBlocks - 1) / lms3dTiles::Size + 1; }

private:
  void FillCorners(lms3dTiles& tiles) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dBeamGrid Grid;
  const int BlocksPerTurn;
  const int NumberOfBlocks;

  /// The cosine of half the angle between the first and the last turn, for each level.
  float HalfCosines[3];
};

#endif
