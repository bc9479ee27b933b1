// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the tiles that few triangles of a large scene can meet, and those that none can.
 *
 * In open country the sky meets no cluster of triangles, and the ground beside the sensor meets
 * few.
 */
#ifndef lms3dClusterDivision_h
#define lms3dClusterDivision_h

#include "Casting/lms3dNormalization.h"
#include "Casting/lms3dTileBlock.h"
#include "Casting/lms3dTileClassifier.h"
#include "Casting/lms3dTileGrid.h"
#include "Casting/lms3dTriangleClusters.h"
#include "Kernels/lms3dPacketKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dClusterDivision
{
public:
  /// The sensor of the classifier's view is within the normalization's bounding sphere. References
  /// must outlive the object. Uses the threads of the calling TBB arena.
  lms3dClusterDivision(const lms3dTriangleClusters& clusters,
    const lms3dNormalization& normalization, const lms3dTileClassifier& classifier,
    const lms3dTileGrid& grid);

  /// Returns all blocks of the grid. Uses the threads of the calling TBB arena. Tiles with more
  /// candidates than `maximum` are crowded.
  std::vector<lms3dTileBlock> Divide(std::size_t maximum) const;

private:
  /// A cluster, or a part of one.
  struct Group
  {
    /// In diagonals of the scene.
    lms3dTileBox Box;

    /// Where the triangles stand in the list of all, and their number.
    std::uint32_t First;
    std::uint32_t Count;
  };

  /// Some clusters that are far from the sensor, and the parts of others that are near to it.
  struct Part
  {
    std::vector<Group> Chosen;

    /// Which of them each block can meet, in words of 32 groups: a word for each block, then the
    /// next words.
    std::vector<std::uint32_t> Met;
  };

  /// What a tile can meet.
  struct Contents
  {
    std::vector<const Group*> Whole;

    /// Triangles of other groups.
    std::vector<std::uint32_t> Triangles;

    /// How many triangles these are together.
    std::size_t Count = 0;
  };

  /// What the tiles of a block can meet.
  struct ContentsOfBlock
  {
    std::array<Contents, lms3dTiles::Size> OfTiles;

    /// The tiles with more triangles than the maximum. No more are added to them.
    std::uint32_t Crowded = 0;
    const std::size_t Maximum;
  };

  std::vector<Group> Choose(std::size_t begin, std::size_t end) const;
  Part DividePart(std::size_t begin, std::size_t end, const std::vector<lms3dTiles>& blocks) const;
  lms3dTileBlock DivideBlock(int number, std::size_t maximum) const;
  void AddGroup(const Group& group, std::uint32_t present, const lms3dTiles& tiles,
    ContentsOfBlock& contents) const;
  void AddTriangles(const Group& group, std::uint32_t met, const lms3dTiles& tiles,
    ContentsOfBlock& contents) const;
  void AppendTriangles(const Contents& contents, lms3dTileBlock& block) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleClusters& All;
  const lms3dTileClassifier& Classifier;
  const lms3dTileGrid& Grid;

  /// The sensor, in diagonals of the scene.
  float Position[3];
  std::vector<Part> Parts;
};

#endif
