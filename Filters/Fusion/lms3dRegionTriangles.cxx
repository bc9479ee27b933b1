// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionTriangles.h"

#include "Fusion/lms3dCreaseSnapping.h"
#include "Fusion/lms3dOutlineSimplifier.h"

#include <optional>

std::vector<lms3dTriangle2> lms3dTriangulateRegion(const lms3dRegion& region,
  const std::vector<lms3dCreaseLine>& creases, const lms3dFusedTile& tile, double tolerance,
  double reach)
{
  const std::vector<lms3dLoop> outlines = lms3dTraceOutlines(region);
  // Without creases, the corners on the sides of the tile alone are fixed.
  for (const std::vector<lms3dCreaseLine>& lines : { creases, std::vector<lms3dCreaseLine>() })
  {
    std::vector<bool> isFixed;
    const std::vector<lms3dLoop> snapped =
      lms3dSnapToCreases(outlines, lines, region, tile, isFixed);
    lms3dOutlineSimplifier simplifier(region, snapped, isFixed, tolerance, reach);
    if (const auto triangles = lms3dTriangulateOutlines(simplifier.Simplify()))
    {
      return *triangles;
    }
  }
  return lms3dTriangulateOutlines(outlines).value_or(std::vector<lms3dTriangle2>());
}
