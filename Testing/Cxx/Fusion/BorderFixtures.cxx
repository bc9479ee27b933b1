// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/BorderFixtures.h"

#include "Fusion/Outlines/lms3dSegment2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

void Set(lms3dRegion::BitsOf bits, std::int32_t u, std::int32_t v, lms3dRegion& region)
{
  region.SetRow(bits, v, u, u, true, true, [](int) {});
}

bool IsInside(const lms3dPoint2& point, const lms3dLoop& loop)
{
  bool isInside = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const lms3dPoint2& a = loop[i];
    const lms3dPoint2& b = loop[(i + 1) % loop.size()];
    isInside ^= (a[1] > point[1]) != (b[1] > point[1]) &&
      point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]);
  }
  return isInside;
}

double GetDistance(const lms3dPoint2& point, const lms3dLoop& loop)
{
  double least = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const lms3dSegment2 edge(loop[i], loop[(i + 1) % loop.size()]);
    least = std::min(least, edge.GetSquaredDistance(point));
  }
  return std::sqrt(least);
}

void ExpectLimitsKept(const lms3dLoop& loop, const lms3dRegion& region, double reach)
{
  for (std::int32_t v = 0; v < 128; ++v)
  {
    for (std::int32_t u = 0; u < 256; ++u)
    {
      const lms3dPoint2 centre = { u + 0.5, v + 0.5 };
      if (region.Has(&lms3dRegionBlock::Must, u, v) && !IsInside(centre, loop))
      {
        EXPECT_LE(GetDistance(centre, loop), reach) << u << " " << v;
      }
      if (region.Has(&lms3dRegionBlock::Passed, u, v))
      {
        EXPECT_FALSE(IsInside(centre, loop)) << u << " " << v;
        EXPECT_GE(GetDistance(centre, loop), 0.5) << u << " " << v;
      }
    }
  }
}
