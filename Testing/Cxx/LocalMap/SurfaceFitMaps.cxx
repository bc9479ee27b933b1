// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/SurfaceFitMaps.h"

#include <array>
#include <utility>
#include <vector>

namespace
{
using Corners = std::array<lms3dVector, 3>;

/// The four triangles that the middles of the edges make of a triangle on the unit sphere.
std::array<Corners, 4> Divide(const Corners& triangle)
{
  const auto& [a, b, c] = triangle;
  const lms3dVector ab = lms3dNormalize(lms3dAdd(a, b));
  const lms3dVector bc = lms3dNormalize(lms3dAdd(b, c));
  const lms3dVector ca = lms3dNormalize(lms3dAdd(c, a));
  return { { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } } };
}
} // namespace

BallScan::BallScan(const std::function<double(int, int)>& getRange, int beams)
  : Geometry(Alpha, beams, Beta, Turns)
{
  std::vector<double> ranges;
  std::vector<int> ids;
  for (int id = 0; id < beams * Turns; ++id)
  {
    const double range = getRange(id % beams, id / beams);
    if (range > 0.0)
    {
      ranges.push_back(range);
      ids.push_back(id);
    }
  }
  this->Grid.Build(
    this->Geometry, ranges.data(), ids.data(), static_cast<std::int64_t>(ids.size()));
  this->Joins.Find(this->Grid, 0.1);
}

RoundMap::RoundMap(double radius, int firstOctant)
  : Size(radius)
{
  const lms3dVector x = { 1, 0, 0 };
  const lms3dVector y = { 0, 1, 0 };
  const lms3dVector z = { 0, 0, 1 };
  for (int octant = firstOctant; octant < 8; ++octant)
  {
    lms3dVector a = lms3dScale(x, octant & 1 ? -1.0 : 1.0);
    lms3dVector b = lms3dScale(y, octant & 2 ? -1.0 : 1.0);
    const lms3dVector c = lms3dScale(z, octant & 4 ? -1.0 : 1.0);
    if (lms3dDot(lms3dCross(a, b), c) > 0.0)
    {
      std::swap(a, b);
    }
    for (const Corners& quarter : Divide({ a, b, c }))
    {
      for (const auto& [d, e, f] : Divide(quarter))
      {
        this->Map.Triangles.push_back({ this->Add(d), this->Add(e), this->Add(f) });
      }
    }
  }
  this->Map.PatchIds.assign(this->Map.Triangles.size(), 0);
  this->Map.NumberOfPatches = 1;
}

std::int32_t RoundMap::Add(const lms3dVector& direction)
{
  const auto [entry, isNew] =
    this->Numbers.insert({ direction, static_cast<std::int32_t>(this->Map.Points.size()) });
  if (isNew)
  {
    this->Map.Points.push_back(lms3dScale(direction, this->Size));
  }
  return entry->second;
}

std::int32_t FindVertex(const lms3dVertexStars& stars, const lms3dVector& direction)
{
  std::int32_t vertex = 0;
  while (lms3dDot(stars.GetVertex(vertex).Corner.Position, direction) < 1.0 - 1e-9)
  {
    ++vertex;
  }
  return vertex;
}
