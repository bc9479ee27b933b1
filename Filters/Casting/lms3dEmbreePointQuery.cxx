// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreePointQuery.h"

#include "Casting/lms3dEmbreeTree.h"

namespace
{
// How far the search goes beyond the nearest triangle so far, because point and scene are rounded
// to single precision. The rounding of the point is relative to its distance.
constexpr float SearchMargin = 4e-6f;
constexpr float SearchFactor = 1.0f + 1e-6f;

/// The argument of Embree's callback.
struct Search
{
  lms3dNearestTest* Test;
  const lms3dNormalization* Normalization;

  /// Takes metres, returns units of the normalized scene.
  float GetRadius(double distance) const
  {
    return static_cast<float>(this->Normalization->NormalizeLength(distance)) * SearchFactor +
      SearchMargin;
  }
};

bool TestTriangle(RTCPointQueryFunctionArguments* args)
{
  const Search* search = static_cast<const Search*>(args->userPtr);
  const float radius = search->GetRadius(search->Test->Test(args->primID));
  if (!(radius < args->query->radius))
  {
    return false;
  }
  args->query->radius = radius;
  return true;
}
} // namespace

void lms3dFindNearestTriangle(const lms3dEmbreeTriangles& triangles, const double point[3],
  double maximumDistance, lms3dNearestTest& test)
{
  const lms3dNormalization& normalization = triangles.GetTree().GetNormalization();
  Search search = { &test, &normalization };
  RTCPointQuery query;
  query.x = static_cast<float>(normalization.NormalizeCoordinate(point, 0));
  query.y = static_cast<float>(normalization.NormalizeCoordinate(point, 1));
  query.z = static_cast<float>(normalization.NormalizeCoordinate(point, 2));
  query.time = 0.0f;
  query.radius = search.GetRadius(maximumDistance);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(triangles.GetTree().GetScene(), &query, &context, &TestTriangle, &search);
}
