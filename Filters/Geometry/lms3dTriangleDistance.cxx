// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
double GetSquaredDistanceToEdge(const double* point, const double* a, const double* b)
{
  const lms3dVector along = lms3dSubtract(b, a);
  const lms3dVector to = lms3dSubtract(point, a);
  const double squaredLength = lms3dDot(along, along);
  const double at =
    squaredLength > 0.0 ? std::clamp(lms3dDot(to, along) / squaredLength, 0.0, 1.0) : 0.0;
  const lms3dVector rest = lms3dSubtract(to, lms3dScale(along, at));
  return lms3dDot(rest, rest);
}
} // namespace

lms3dVector lms3dGetWeightedNormal(const lms3dCorners& corners)
{
  return lms3dCross(lms3dSubtract(corners[1], corners[0]), lms3dSubtract(corners[2], corners[0]));
}

double lms3dGetDistance(const double point[3], const lms3dCorners& corners)
{
  const lms3dVector normal = lms3dGetWeightedNormal(corners);
  const double squaredNormal = lms3dDot(normal, normal);
  const bool hasArea = squaredNormal > 0.0;
  bool isAbove = hasArea;
  double minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const double* a = corners[i];
    const double* b = corners[(i + 1) % 3];
    // If the point projects beyond an edge, the nearest point of the triangle lies on an edge.
    if (!hasArea ||
      lms3dDot(lms3dCross(normal, lms3dSubtract(b, a)), lms3dSubtract(point, a)) < 0.0)
    {
      isAbove = false;
      minimum = std::min(minimum, GetSquaredDistanceToEdge(point, a, b));
    }
  }
  return isAbove
    ? std::abs(lms3dDot(normal, lms3dSubtract(point, corners[0]))) / std::sqrt(squaredNormal)
    : std::sqrt(minimum);
}
