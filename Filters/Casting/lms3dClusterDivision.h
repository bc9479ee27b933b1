// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the tiles that few triangles of a large scene can meet, and those that none can.
 *
 * In open country the sky meets no cluster of triangles, and the ground beside the sensor meets few.
 */
#ifndef lms3dClusterDivision_h
#define lms3dClusterDivision_h

#include "Casting/lms3dNormalization.h"
#include "Casting/lms3dTileBlock.h"
#include "Casting/lms3dTileGrid.h"
#include "Casting/lms3dTriangleClusters.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dClusterDivision
{
public:
  /// `origin` is the sensor's position in world coordinates, within the normalization's bounding sphere.
  /// References must outlive the object.
  lms3dClusterDivision(const lms3dTriangleClusters& clusters,
    const lms3dNormalization& normalization, const double origin[3], const lms3dTileGrid& grid);

  /// Returns all blocks of the grid. Uses the threads of the calling TBB arena. Tiles with more candidates
  /// than `maximum` are crowded.
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

  std::vector<Groups> DivideGrid() const;
  lms3dTileBlock DivideBlock(int number, const Groups& groups, std::size_t maximum) const;
  void AppendTriangles(const Groups& groups, lms3dTileBlock& block) const;
  std::size_t CountTriangles(const Groups& groups) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleClusters& All;
  const lms3dTileGrid& Grid;

  /// The clusters that are far from the sensor, and the parts of those near to it.
  std::vector<Group> Chosen;
};

#endif
