// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides for whole tiles of a scan at once which triangle is the nearest.
 *
 * Source of the idea: J. Warnock, "A hidden surface algorithm for computer generated halftone
 * pictures", 1969. The grid of beams is divided three times: into blocks of 64 x 64 beams, tiles of
 * 16 x 16, and packets of 4 x 4. Each step decides for 16 parts at once which triangles they can
 * meet. A triangle that covers a part hides all that lies behind it there. If nothing else is left,
 * the part is decided, without a look at its beams.
 *
 * lms3dTriangleDivision makes the first two divisions. In scenes too large for this, they take
 * clusters of triangles, see lms3dClusterDivision. Tiles that few triangles can meet are then
 * divided into packets likewise. All others are left to Embree.
 */
#ifndef lms3dTileSearch_h
#define lms3dTileSearch_h

#include "Casting/lms3dBeamGrid.h"
#include "Casting/lms3dExactView.h"
#include "Casting/lms3dGridCaster.h"
#include "Casting/lms3dNormalization.h"
#include "Casting/lms3dTileBlock.h"
#include "Casting/lms3dTileCandidateLists.h"
#include "Casting/lms3dTileClassifier.h"
#include "Casting/lms3dTileGrid.h"
#include "Casting/lms3dTriangleClusters.h"

#include <cstddef>
#include <memory>
#include <vector>

class lms3dTileSearch
{
public:
  /// The packets along each side of a tile.
  static constexpr int PacketsPerSide = lms3dTileGrid::TileSide / lms3dBeamGrid::Side;

  ///@{
  /// Returns whether the search can divide a grid, and whether that can pay for a number of
  /// triangles or clusters. The answer does not depend on the machine.
  static bool IsSuitable(const lms3dBeamGrid& grid, std::size_t triangles);
  static bool IsSuitable(const lms3dBeamGrid& grid, const lms3dTriangleClusters& clusters);
  ///@}

  /**
   * Divides the grid into tiles, with the threads of the calling TBB arena. Makes the narrow
   * triangles of the view, too. Returns null if too many triangles remain for this to pay. View and
   * the arrays of the grid must outlive the object.
   */
  static std::unique_ptr<lms3dTileSearch> New(lms3dExactView& view, const lms3dBeamGrid& grid);

  /// Divides a scene that is too large for that, by its clusters. The view must keep or have its
  /// narrow triangles. The sensor is within the normalization's bounding sphere.
  static std::unique_ptr<lms3dTileSearch> New(const lms3dExactView& view, const lms3dBeamGrid& grid,
    const lms3dTriangleClusters& clusters, const lms3dNormalization& normalization);

  /// Sets Triangle of the packets of some tiles side by side, except for those that it returns. The
  /// rectangle begins where a tile begins, and has at most PacketsPerSide rows. Several threads may
  /// call this at once.
  lms3dPacketMask FindNearest(
    const lms3dPacketRectangle& rectangle, lms3dBeamPacket* packets) const;

  /// Returns whether all beams of the tile that begins at a turn and beam hit one triangle, or
  /// none, and sets this triangle or lms3dBeamPacket::NoTriangle.
  bool IsDecided(int turn, int beam, std::int32_t& triangle) const;

  /// Returns true only if no beam of such a rectangle hits a triangle.
  bool IsEmpty(const lms3dPacketRectangle& rectangle) const;

private:
  struct PacketsOfTile;

  lms3dTileSearch(const lms3dExactView& view, const lms3dBeamGrid& grid);
  void FindInTile(const PacketsOfTile& packets) const;
  void FindInParts(
    const lms3dTileCandidate* candidates, std::size_t count, const PacketsOfTile& packets) const;
  void TestCandidates(const lms3dTileCandidateLists& parts, int part, lms3dNarrowCache* kept,
    lms3dBeamPacket& packet) const;

  lms3dTileClassifier Classifier;
  const lms3dTileGrid Grid;
  std::vector<lms3dTileBlock> Blocks;
};

#endif
