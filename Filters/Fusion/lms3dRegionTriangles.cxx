// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionTriangles.h"

#include "Fusion/lms3dBorderLimits.h"
#include "Fusion/lms3dCornerMerger.h"
#include "Fusion/lms3dCreaseSnapping.h"
#include "Fusion/lms3dOutlineCorners.h"
#include "Fusion/lms3dOutlineCrossings.h"
#include "Fusion/lms3dOutlineSimplifier.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace
{
// How often borders move to creases.
constexpr int Attempts = 6;
// Cells: how near to a crossing corners do not move. If they then cross at the same places, twice
// as far.
constexpr double NearCrossing = 24.0;

/// Makes the outlines of a region simpler.
class Straightener
{
public:
  Straightener(const std::vector<lms3dLoop>& outlines, const lms3dRegion& region,
    const lms3dFusedTile& tile, double tolerance, double reach)
    : Outlines(outlines)
    , Region(region)
    , Tile(tile)
    , Tolerance(tolerance)
    , Reach(reach)
  {
  }

  /// Corners within a distance of the places do not move to creases.
  std::vector<lms3dLoop> Straighten(const std::vector<lms3dCreaseLine>& creases,
    const std::vector<lms3dPoint2>& places, double distance) const
  {
    std::vector<bool> isFixed;
    const std::vector<lms3dLoop> snapped = lms3dSnapToCreases(
      this->Outlines, creases, this->Region, this->Tile, places, distance, isFixed);
    lms3dOutlineCorners corners(snapped, isFixed);
    lms3dBorderLimits limits(this->Region, corners.GetPoints().size(), this->Reach);
    lms3dOutlineSimplifier(this->Tolerance, corners, limits).Simplify();
    lms3dCornerMerger(this->Tolerance, this->Tile, corners, limits).Merge();
    // Corners that moved let others go, and the reverse.
    lms3dOutlineSimplifier again(this->Tolerance, corners, limits);
    again.Simplify();
    if (!again.GetNeighbours().empty())
    {
      lms3dCornerMerger(this->Tolerance, this->Tile, corners, limits)
        .MergeNear(again.GetNeighbours());
      lms3dOutlineSimplifier(this->Tolerance, corners, limits).Simplify();
    }
    return corners.GetLoops();
  }

private:
  const std::vector<lms3dLoop>& Outlines;
  const lms3dRegion& Region;
  const lms3dFusedTile& Tile;
  const double Tolerance;
  const double Reach;
};
} // namespace

std::vector<lms3dTriangle2> lms3dTriangulateRegion(const std::vector<lms3dLoop>& outlines,
  const lms3dRegion& region, const std::vector<lms3dCreaseLine>& creases,
  const lms3dFusedTile& tile, double tolerance, double reach)
{
  const Straightener straightener(outlines, region, tile, tolerance, reach);
  std::vector<lms3dPoint2> crossings;
  double distance = NearCrossing;
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    const std::vector<lms3dLoop> loops = straightener.Straighten(creases, crossings, distance);
    if (const auto triangles = lms3dTriangulateOutlines(loops))
    {
      return *triangles;
    }
    const std::size_t before = crossings.size();
    for (const lms3dPoint2& found : lms3dFindCrossings(loops))
    {
      if (std::find(crossings.begin(), crossings.end(), found) == crossings.end())
      {
        crossings.push_back(found);
      }
    }
    if (crossings.empty() || creases.empty())
    {
      break;
    }
    distance *= crossings.size() == before ? 2.0 : 1.0;
  }
  // Without creases, the corners on the sides of the tile alone are fixed.
  for (const std::vector<lms3dLoop>& loops : { straightener.Straighten({}, {}, 0.0), outlines })
  {
    if (const auto triangles = lms3dTriangulateOutlines(loops))
    {
      return *triangles;
    }
  }
  return {};
}
