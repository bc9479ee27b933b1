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
  /// must outlive the object.
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

  /// Groups, by their numbers.
  using Groups = std::vector<std::uint32_t>;

  /// What a tile can meet.
  struct Contents
  {
    Groups Whole;

    /// Triangles of other groups.
    Groups Triangles;
  };

  std::vector<Groups> DivideGrid() const;
  lms3dTileBlock DivideBlock(int number, const Groups& groups, std::size_t maximum) const;
  void AddTriangles(const Group& group, std::uint32_t met, const lms3dTiles& tiles,
    std::array<Contents, lms3dTiles::Size>& ofTiles) const;
  void AppendTriangles(const Contents& contents, lms3dTileBlock& block) const;
  std::size_t CountTriangles(const Contents& contents) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleClusters& All;
  const lms3dTileClassifier& Classifier;
  const lms3dTileGrid& Grid;

  /// The clusters that are far from the sensor, and the parts of those near to it.
  std::vector<Group> Chosen;
};

#endif
