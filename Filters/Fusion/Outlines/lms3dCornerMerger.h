// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Merges corners of outlines.
 */
#ifndef lms3dCornerMerger_h
#define lms3dCornerMerger_h

#include "Fusion/Outlines/lms3dBorderLimits.h"
#include "Fusion/Outlines/lms3dCornerMerge.h"
#include "Fusion/Outlines/lms3dFusedTile.h"
#include "Fusion/Outlines/lms3dOutlineCorners.h"

#include <array>
#include <optional>
#include <vector>

/**
 * Two successive corners that are not fixed become one, which may lie anywhere: where the edges
 * beside the two meet, or between the two. Then up to five corners become one. So a border that
 * goes to and fro between returns and beams that passed becomes straight, although none of its
 * corners can go. If the last of the corners is fixed, it alone can stay. The new corner is not
 * sharp (lms3dIsSharpCorner). At last corners move outwards by up to four cells along each of three
 * ways (lms3dFindWaysOutwards), to points at most two cells from the region, so that the region has
 * returns beside its border. The outline stays within a tolerance of what it was, keeps the limits
 * of borders, and crosses no other edge.
 */
class lms3dCornerMerger
{
public:
  /// Keeps references. The tolerance is in cells. The edges of the limits have the numbers of their
  /// first corners. New corners lie in the tile.
  lms3dCornerMerger(double tolerance, const lms3dFusedTile& tile, lms3dOutlineCorners& corners,
    lms3dBorderLimits& limits);

  using Corner = lms3dOutlineCorners::Corner;

  /// Merges corners, and moves edges outwards.
  void Merge();

private:
  using Triangle = lms3dOutlineCorners::Triangle;
  /// The ends of three successive edges.
  using ThreeEdges = std::array<lms3dPoint2, 4>;

  void DropGone();
  void MoveOutwards();
  void MergeQueued(std::size_t longest);
  void QueueBefore(Corner corner, std::size_t count);
  bool MergeAt(Corner corner, std::size_t longest);
  bool MergeChain(Corner behind);
  void Prepare(const std::vector<Corner>& chain);
  void MoveOutwards(Corner corner);
  void MoveAlong(Corner corner, const lms3dPoint2& way);
  bool MayMerge(const lms3dCornerMerge& merge, const std::vector<Corner>& chain);
  void Apply(const lms3dCornerMerge& merge, const std::vector<Corner>& chain);
  bool IsFar(const lms3dCornerMerge& merge) const;
  bool IsNearOutline(const lms3dCornerMerge& merge, const std::vector<Corner>& chain);
  bool AreNeighboursNear(const lms3dCornerMerge& merge, const std::vector<Corner>& chain) const;
  bool AreNear(Corner from, Corner to, const ThreeEdges& points) const;
  void Queue(Corner corner)
  {
    if (!this->IsQueued[corner])
    {
      this->IsQueued[corner] = true;
      this->Queued.push_back(corner);
    }
  }

  /// Squared.
  const double Tolerance;
  const lms3dFusedTile& Tile;
  lms3dOutlineCorners& Corners;
  lms3dBorderLimits& Limits;
  /// The corners that have not gone, and perhaps some that have.
  std::vector<Corner> Left;
  /// The corners at which a merge may be possible.
  std::vector<Corner> Queued;
  std::vector<bool> IsQueued;
  /// The corners that become one, with the one before them, and their places.
  std::vector<Corner> Chain;
  std::vector<lms3dPoint2> Points;
  /// The edges of the merge that is tried.
  std::vector<lms3dBorderLimits::Edge> Edges;
  /// A corner that was too far from the last place of the merge that is tried.
  std::optional<Corner> Far;
};

#endif
