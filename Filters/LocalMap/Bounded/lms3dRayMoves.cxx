// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dRayMoves.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Radians. Larger than the rounding of vertices.
constexpr double Margin = 1e-6;
} // namespace

void lms3dRayMoves::Hits::Sort()
{
  std::sort(this->Explained.begin(), this->Explained.end());
  std::sort(this->Blocked.begin(), this->Blocked.end());
}

bool lms3dRayMoves::KeepsBound(
  const lms3dVertexStars& stars, std::int32_t from, std::int32_t to) const
{
  Hits before;
  Hits after;
  stars.ForEachTriangle(from,
    [&](std::int32_t, std::int32_t next, std::int32_t last)
    {
      this->Cast(stars.GetPosition(from), stars.GetPosition(next), stars.GetPosition(last), before);
      return true;
    });
  stars.ForEachSide(from, to,
    [&](std::int32_t next, std::int32_t last)
    {
      this->Cast(stars.GetPosition(to), stars.GetPosition(next), stars.GetPosition(last), after);
      return true;
    });
  before.Sort();
  after.Sort();
  const auto contains = [](const std::vector<GridIndex>& all, const std::vector<GridIndex>& some)
  {
    return std::all_of(some.begin(), some.end(),
      [&](GridIndex index) { return std::binary_search(all.begin(), all.end(), index); });
  };
  return contains(after.Explained, before.Explained) && contains(before.Blocked, after.Blocked);
}

void lms3dRayMoves::Cast(
  const lms3dVector& a, const lms3dVector& b, const lms3dVector& c, Hits& hits) const
{
  const auto visit = [&](GridIndex index, double hit, double distance)
  {
    const double range = this->Sphere.GetRangeOnBeam(index);
    const double halfSpread = this->Sphere.GetPoleHalfSpread(this->Sphere.GetRow(index));
    // The margin of the beam can be far from a triangle at a grazing angle.
    if (range > 0.0 && std::abs(range - hit) + halfSpread <= this->MaximumError &&
      distance <= this->MaximumError)
    {
      hits.Explained.push_back(index);
    }
    else if (!(range > 0.0) || hit < range)
    {
      hits.Blocked.push_back(index);
    }
  };
  this->ForEachBeam(a, b, c, visit);
}

// Calls visit(index, hit, distance) for each beam that hits a triangle: the range at which the beam
// meets it, and the distance of the return.
template <typename Visitor>
void lms3dRayMoves::ForEachBeam(
  const lms3dVector& a, const lms3dVector& b, const lms3dVector& c, const Visitor& visit) const
{
  const lms3dTriangleRasterizer beams(
    this->Sphere, lms3dTriangleCorner(a), lms3dTriangleCorner(b), lms3dTriangleCorner(c), Margin);
  beams.ForEachColumn(
    [&](int column, int first, int last)
    {
      const lms3dTriangleRasterizer::ColumnRanges ranges(beams, column);
      for (int row = first; row <= last; ++row)
      {
        const GridIndex index = this->Sphere.GetIndex(column, row);
        if (!this->Sphere.IsPoleCopy(index))
        {
          const lms3dVector point =
            lms3dScale(this->Sphere.GetDirection(index), this->Sphere.GetRange(index));
          visit(index, ranges.GetRange(row), lms3dGetDistance(point, a, b, c));
        }
      }
    });
}

double lms3dRayMoves::GetLargestDeviation(const lms3dBoundedMap& map) const
{
  std::vector<double> nearest(this->Sphere.GetSize(), std::numeric_limits<double>::infinity());
  for (const std::array<std::int32_t, 3>& corners : map.Triangles)
  {
    this->ForEachBeam(map.Points[corners[0]], map.Points[corners[1]], map.Points[corners[2]],
      [&](GridIndex index, double, double distance)
      { nearest[index] = std::min(nearest[index], distance); });
  }
  double largest = 0.0;
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (this->Sphere.HasReturn(index) && !this->Sphere.IsFilled(index) &&
      !this->Sphere.IsPoleRow(this->Sphere.GetRow(index)) && nearest[index] <= this->MaximumError)
    {
      largest = std::max(largest, nearest[index]);
    }
  }
  return largest;
}
