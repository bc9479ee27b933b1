// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dOutlineSimplifier.h"

#include "Fusion/Outlines/lms3dCornerPlaces.h"
#include "Fusion/Outlines/lms3dSegment2.h"

#include <algorithm>
#include <array>

namespace
{
// Squared cells: corners nearer than this to a line lie on it.
constexpr double OnLine = 1e-12;
// Squared cells: how far a border that is straightened first may move.
constexpr double ToleranceOfSteps = 1.0;
constexpr double Infinite = 1e300;
} // namespace

lms3dOutlineSimplifier::lms3dOutlineSimplifier(
  double tolerance, lms3dOutlineCorners& corners, lms3dBorderLimits& limits)
  : Tolerance(tolerance * tolerance)
  , Corners(corners)
  , Limits(limits)
  , Versions(corners.GetPoints().size(), 0)
{
  this->Buckets.Fill(corners.GetPoints(), [&](Corner corner) { return !corners.HasGone(corner); });
}

// The square of the largest distance of a corner, and of those that went beside it, from the line
// that would take their place; or a square above the limit. The corner itself is often the
// farthest.
double lms3dOutlineSimplifier::GetCost(Corner corner, double limit) const
{
  const Corner from = this->Corners.GetPrevious(corner);
  const Corner to = this->Corners.GetNext(corner);
  const lms3dSegment2 line(this->Corners[from], this->Corners[to]);
  if (this->Corners.IsFixed(corner) && line.GetSquaredDistance(this->Corners[corner]) > OnLine)
  {
    return Infinite;
  }
  const double ofFirst = line.GetSquaredDistance(this->Corners.GetFirstPoint(corner));
  return ofFirst > limit
    ? ofFirst
    : this->Corners.GetDeviation(
        from, to, limit, [&](const lms3dPoint2& point) { return line.GetSquaredDistance(point); });
}

void lms3dOutlineSimplifier::Queue(Corner corner)
{
  const double cost = this->GetCost(corner, this->Tolerance);
  ++this->Versions[corner];
  if (cost <= this->Tolerance)
  {
    this->Candidates.Add({ cost, corner, this->Versions[corner] });
  }
}

bool lms3dOutlineSimplifier::IsEmpty(const Triangle& triangle, Corner corner) const
{
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  const auto [left, right] = std::minmax({ triangle[0][0], triangle[1][0], triangle[2][0] });
  const auto [bottom, top] = std::minmax({ triangle[0][1], triangle[1][1], triangle[2][1] });
  // Structured bindings cannot be captured in C++17.
  const std::array<double, 4> box = { left, right, bottom, top };
  const auto isFree = [&](const lms3dPoint2& point, Corner other)
  {
    if (point[0] < box[0] || point[0] > box[1] || point[1] < box[2] || point[1] > box[3])
    {
      return true;
    }
    return other == corner || other == this->Corners.GetNext(corner) ||
      other == this->Corners.GetPrevious(corner) ||
      !lms3dIsInTriangle(point, triangle, orientation);
  };
  return this->Buckets.AllOf(triangle, isFree);
}

// Whether a neighbour of a corner would be sharp without the corner.
bool lms3dOutlineSimplifier::MakesSharpCorner(Corner corner) const
{
  const Corner before = this->Corners.GetPrevious(corner);
  const Corner behind = this->Corners.GetNext(corner);
  return lms3dIsSharpCorner({ this->Corners[this->Corners.GetPrevious(before)],
           this->Corners[before], this->Corners[behind] }) ||
    lms3dIsSharpCorner({ this->Corners[before], this->Corners[behind],
      this->Corners[this->Corners.GetNext(behind)] });
}

bool lms3dOutlineSimplifier::MayGo(Corner corner) const
{
  const Triangle triangle = this->Corners.GetTriangle(corner);
  if (lms3dGetOrientation(triangle[0], triangle[1], triangle[2]) == 0)
  {
    return true;
  }
  if (lms3dSegment2(triangle[0], triangle[2]).GetSquaredDistance(triangle[1]) <= OnLine)
  {
    return this->IsEmpty(triangle, corner);
  }
  return !this->MakesSharpCorner(corner) &&
    this->Limits.MayJoin(triangle, this->Corners.GetPrevious(corner), corner) &&
    this->IsEmpty(triangle, corner);
}

void lms3dOutlineSimplifier::Remove(Corner corner)
{
  this->Limits.Join(this->Corners.GetTriangle(corner), this->Corners.GetPrevious(corner), corner);
  this->Corners.Remove(corner);
  this->Buckets.Remove(corner);
}

// Takes out the steps of borders that are not along an axis, corner by corner, before the corners
// that are left go in order of their costs.
void lms3dOutlineSimplifier::RemoveSteps()
{
  for (Corner corner = 0; corner < this->Corners.GetSize(); ++corner)
  {
    if (!this->Corners.HasGone(corner) && !this->Corners.IsOfTriangle(corner) &&
      this->GetCost(corner, ToleranceOfSteps) <= ToleranceOfSteps && this->MayGo(corner))
    {
      this->Remove(corner);
    }
  }
}

void lms3dOutlineSimplifier::FindCandidates()
{
  for (Corner corner = 0; corner < this->Corners.GetSize(); ++corner)
  {
    const double cost =
      this->Corners.HasGone(corner) ? Infinite : this->GetCost(corner, this->Tolerance);
    if (cost <= this->Tolerance)
    {
      this->Candidates.AddFirst({ cost, corner, 0 });
    }
  }
  this->Candidates.SortFirst();
}

void lms3dOutlineSimplifier::Simplify()
{
  this->RemoveSteps();
  this->FindCandidates();
  while (!this->Candidates.IsEmpty())
  {
    const lms3dCornerCandidate candidate = this->Candidates.TakeNext();
    const Corner corner = candidate.Number;
    if (!this->Corners.HasGone(corner) && candidate.Version == this->Versions[corner] &&
      !this->Corners.IsOfTriangle(corner) && this->MayGo(corner))
    {
      this->Remove(corner);
      this->Queue(this->Corners.GetPrevious(corner));
      this->Queue(this->Corners.GetNext(corner));
    }
  }
}
