// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dMergeClearance.h"

#include "Fusion/Cells/lms3dBox2.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
using Corner = lms3dOutlineCorners::Corner;
using Triangle = lms3dCornerMerge::Triangle;
using Segment = std::array<lms3dPoint2, 2>;

int GetOrientation(const Segment& segment, const lms3dPoint2& point)
{
  return lms3dGetOrientation(segment[0], segment[1], point);
}

// Whether two segments have a point in common.
bool DoMeet(const Segment& a, const Segment& b)
{
  return GetOrientation(a, b[0]) * GetOrientation(a, b[1]) <= 0 &&
    GetOrientation(b, a[0]) * GetOrientation(b, a[1]) <= 0;
}

bool IsIn(const lms3dPoint2& point, const Triangle& triangle)
{
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  return orientation != 0 && lms3dIsInTriangle(point, triangle, orientation);
}

/// The outlines before and after a merge, and the triangles between them.
class Merge
{
public:
  explicit Merge(const lms3dCornerMerge& merge)
    : Before(merge.Before)
    , Corner(merge.Corner)
  {
    this->Box.Add(merge.Corner);
    for (std::size_t i = 0; i < merge.GetNumberOfEdges(); ++i)
    {
      this->Triangles.push_back(merge.GetTriangle(i));
    }
    for (const lms3dPoint2& point : merge.Before)
    {
      this->Box.Add(point);
    }
  }

  /// Whether neither end lies in triangles of other edges than its own.
  bool AreEndsApart() const
  {
    const auto begin = this->Triangles.begin();
    const auto end = this->Triangles.end();
    return !IsInAny(this->Before.front(), begin + 1, end) &&
      !IsInAny(this->Before.back(), begin, end - 1);
  }

  /// Whether an edge may be near. Others are apart.
  bool BoxMeets(const Segment& segment) const
  {
    lms3dBox2 edge;
    edge.Add(segment[0]);
    edge.Add(segment[1]);
    return this->Box.IsNear(edge, 0.0);
  }

  /// Whether an edge is apart that has no end in common with the merge.
  bool IsApart(const Segment& edge) const
  {
    return !this->HasInside(edge[0]) && !DoMeet(this->GetSpoke(0), edge) &&
      !DoMeet(this->GetSpoke(this->GetLast()), edge) && this->AreInnerSpokesApart(edge);
  }

  /// Whether an edge is apart that ends at the first corner.
  bool IsApartBefore(const Segment& edge) const
  {
    return !this->HasInside(edge[0]) && GetOrientation(this->GetSpoke(0), edge[0]) != 0 &&
      !DoMeet(this->GetSpoke(this->GetLast()), edge) && this->AreInnerSpokesApart(edge);
  }

  /// Whether an edge is apart that begins at the last corner. It may end at the first one.
  bool IsApartBehind(const Segment& edge) const
  {
    const bool isClosed = edge[1] == this->Before.front();
    const Segment first = this->GetSpoke(0);
    return GetOrientation(this->GetSpoke(this->GetLast()), edge[1]) != 0 &&
      (isClosed ? GetOrientation(first, edge[0]) != 0 : !DoMeet(first, edge)) &&
      this->AreInnerSpokesApart(edge);
  }

private:
  using Place = std::vector<Triangle>::const_iterator;

  static bool IsInAny(const lms3dPoint2& point, Place begin, Place end)
  {
    return std::any_of(begin, end, [&](const Triangle& triangle) { return IsIn(point, triangle); });
  }

  bool HasInside(const lms3dPoint2& point) const
  {
    return IsInAny(point, this->Triangles.begin(), this->Triangles.end());
  }

  std::size_t GetLast() const { return this->Before.size() - 1; }

  /// From a corner of the outline before the merge to the new corner.
  Segment GetSpoke(std::size_t i) const { return { this->Before[i], this->Corner }; }

  bool AreInnerSpokesApart(const Segment& edge) const
  {
    for (std::size_t i = 1; i < this->GetLast(); ++i)
    {
      if (DoMeet(this->GetSpoke(i), edge))
      {
        return false;
      }
    }
    return true;
  }

  const std::vector<lms3dPoint2>& Before;
  const lms3dPoint2& Corner;
  lms3dBox2 Box;
  std::vector<Triangle> Triangles;
};
} // namespace

bool lms3dIsMergeApart(const lms3dCornerMerge& merge, const std::vector<Corner>& chain,
  const std::vector<Corner>& left, const lms3dOutlineCorners& corners)
{
  const Merge area(merge);
  const auto isApart = [&](Corner other)
  {
    const Corner end = corners.GetNext(other);
    const Segment edge = { corners[other], corners[end] };
    if (corners.HasGone(other) || !area.BoxMeets(edge) ||
      std::find(chain.begin(), chain.end() - 1, other) < chain.end() - 1)
    {
      return true;
    }
    if (other == chain.back())
    {
      return area.IsApartBehind(edge);
    }
    return end == chain.front() ? area.IsApartBefore(edge) : area.IsApart(edge);
  };
  return area.AreEndsApart() && std::all_of(left.begin(), left.end(), isApart);
}
