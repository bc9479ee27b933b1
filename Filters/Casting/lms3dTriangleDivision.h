// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The first two divisions of lms3dTileSearch in a small scene, by all its triangles.
 */
#ifndef lms3dTriangleDivision_h
#define lms3dTriangleDivision_h

#include "Casting/lms3dExactView.h"
#include "Casting/lms3dTileBlock.h"
#include "Casting/lms3dTileClassifier.h"
#include "Casting/lms3dTileGrid.h"

#include <cstddef>
#include <vector>

class lms3dTriangleDivision
{
public:
  /// Computes the narrow triangles of the view and the classifier's corners as well, so that the
  /// threads wait for each other only once. Uses the threads of the calling TBB arena. References
  /// must outlive the object.
  lms3dTriangleDivision(
    lms3dExactView& view, lms3dTileClassifier& classifier, const lms3dTileGrid& grid);

  /// Returns how many triangles the blocks of the grid can meet, added up over the blocks.
  std::size_t CountCandidates() const;

  /// Returns all blocks of the grid. Uses the threads of the calling TBB arena.
  std::vector<lms3dTileBlock> Divide() const;

private:
  /// For each group of sixteen blocks, the candidates among some of the triangles. The blocks stand
  /// in the place of tiles.
  using Part = std::vector<lms3dTileBlock>;

  Part DividePart(std::size_t begin, std::size_t end, const std::vector<lms3dTiles>& groups) const;
  lms3dTileBlock DivideBlock(int number) const;

  const lms3dTileClassifier& Classifier;
  const lms3dTileGrid& Grid;

  /// The first triangles, the next ones, and so on. They depend neither on the machine nor on the
  /// threads.
  std::vector<Part> Parts;
};

#endif
