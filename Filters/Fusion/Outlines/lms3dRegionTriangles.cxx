// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dRegionTriangles.h"

#include "Fusion/Outlines/lms3dBorderLimits.h"
#include "Fusion/Outlines/lms3dCornerMerger.h"
#include "Fusion/Outlines/lms3dCreasePlaces.h"
#include "Fusion/Outlines/lms3dCreaseSnapping.h"
#include "Fusion/Outlines/lms3dOutlineCorners.h"
#include "Fusion/Outlines/lms3dOutlineCrossings.h"
#include "Fusion/Outlines/lms3dOutlineSimplifier.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace
{
// How often borders move to creases.
constexpr int Attempts = 6;
// Cells: how near to a crossing corners do not move. If they then cross at the same places, twice
// as far.
constexpr double NearCrossing = 24.0;

/// Outlines that are simpler. If `Crossings` has points, corners were not merged.
struct Straightened
{
  std::vector<lms3dLoop> Loops;
  std::vector<lms3dPoint2> Crossings;
};

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

  /// Corners within a distance of the places do not move to creases. If edges cross then, corners
  /// are not merged, since merges would take time and leave most crossings as they are.
  Straightened Straighten(const std::vector<lms3dCreaseLine>& creases,
    const std::vector<lms3dPoint2>& places, double distance) const
  {
    std::vector<bool> isFixed;
    const std::vector<lms3dLoop> snapped = lms3dSnapToCreases(
      this->Outlines, creases, this->Region, this->Tile, places, distance, isFixed);
    lms3dOutlineCorners corners(snapped, isFixed);
    lms3dBorderLimits limits(this->Region, corners.GetPoints().size(), this->Reach);
    lms3dOutlineSimplifier(this->Tolerance, corners, limits).Simplify();
    std::vector<lms3dPoint2> crossings = lms3dFindCrossingEdges(corners.GetLoops());
    if (crossings.empty())
    {
      this->MergeCorners(corners, limits);
    }
    return { corners.GetLoops(), std::move(crossings) };
  }

private:
  // Borders that moved outwards let more corners go and become one.
  void MergeCorners(lms3dOutlineCorners& corners, lms3dBorderLimits& limits) const
  {
    lms3dCornerMerger(this->Tolerance, this->Tile, corners, limits).Merge();
    lms3dOutlineSimplifier(this->Tolerance, corners, limits).Simplify();
    lms3dCornerMerger(this->Tolerance, this->Tile, corners, limits).Merge();
  }

  const std::vector<lms3dLoop>& Outlines;
  const lms3dRegion& Region;
  const lms3dFusedTile& Tile;
  const double Tolerance;
  const double Reach;
};

std::optional<std::vector<lms3dTriangle2>> Triangulate(const Straightened& made)
{
  return made.Crossings.empty() ? lms3dTriangulateOutlines(made.Loops) : std::nullopt;
}

// Adds the places at which outlines without triangles cross, each once.
void AddCrossings(const Straightened& made, std::vector<lms3dPoint2>& crossings)
{
  for (const lms3dPoint2& found :
    made.Crossings.empty() ? lms3dFindCrossings(made.Loops) : made.Crossings)
  {
    if (std::find(crossings.begin(), crossings.end(), found) == crossings.end())
    {
      crossings.push_back(found);
    }
  }
}
} // namespace

std::vector<lms3dTriangle2> lms3dTriangulateRegion(const std::vector<lms3dLoop>& outlines,
  const lms3dRegion& region, const std::vector<lms3dCreaseLine>& creases,
  const lms3dFusedTile& tile, double tolerance, double reach)
{
  const std::vector<lms3dCreaseLine> near = lms3dFindCreasesNear(outlines, creases);
  const Straightener straightener(outlines, region, tile, tolerance, reach);
  std::vector<lms3dPoint2> crossings;
  double distance = NearCrossing;
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    const Straightened made = straightener.Straighten(near, crossings, distance);
    if (const auto triangles = Triangulate(made))
    {
      return *triangles;
    }
    const std::size_t before = crossings.size();
    AddCrossings(made, crossings);
    if (crossings.empty() || near.empty())
    {
      break;
    }
    distance *= crossings.size() == before ? 2.0 : 1.0;
  }
  // Without creases, the corners on the sides of the tile alone are fixed.
  for (const std::vector<lms3dLoop>& loops :
    { straightener.Straighten({}, {}, 0.0).Loops, outlines })
  {
    if (const auto triangles = lms3dTriangulateOutlines(loops))
    {
      return *triangles;
    }
  }
  return {};
}
