// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which planes of a fused map go when better ones take their place.
 */
#include "Fusion/lms3dFusedPlanes.h"
#include "Fusion/lms3dWeakPlanes.h"

#include <gtest/gtest.h>

#include <cstdint>

TEST(LMS3DFusedPlanes, LoseFacetsWhereSurfaceGrows)
{
  const lms3dMappedReturn mapped = { { 0.5, 0.7, 1.0 }, { 0.0, 0.0, -1.0 }, 2.0, 0, 0 };
  lms3dFusedPlanes planes(0.01);
  planes.AddFacet(mapped);
  const int floor = planes.MakePlane({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  lms3dRaster& raster = planes[floor].Raster;
  const lms3dPoint2 place = planes[floor].Frame.ToCells(mapped.Point);
  const std::int32_t column = lms3dGetCellOf(place[0]);
  const std::int32_t row = lms3dGetCellOf(place[1]);
  const auto grow = [&](std::int32_t cell)
  {
    lms3dCellStrip strip;
    strip.Row = row;
    strip.Add(cell, cell);
    raster.SetGuess(strip);
    planes.GrowBox(floor, mapped.Point);
    planes.AcceptGuesses(floor);
    lms3dDissolveWeakPlanes(planes);
  };
  grow(column + 1);
  EXPECT_EQ(planes[0].Verbatim.size(), 1);
  EXPECT_EQ(planes[0].Returns.size(), 1);
  EXPECT_FALSE(raster.Has(&lms3dRasterBlock::Must, column, row));
  grow(column);
  EXPECT_TRUE(planes[0].Verbatim.empty());
  EXPECT_EQ(planes[0].Raster.GetNumberOfBlocks(), 0);
  EXPECT_TRUE(raster.Has(&lms3dRasterBlock::Must, column, row));
  EXPECT_EQ(planes.GetSize(), 2);
}
