// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dOutlineSimplifier.h"

#include "Fusion/lms3dRasterRows.h"
#include "Fusion/lms3dSegment2.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
std::size_t CountCorners(const std::vector<lms3dLoop>& loops)
{
  std::size_t count = 0;
  for (const lms3dLoop& loop : loops)
  {
    count += loop.size();
  }
  return count;
}

// Squared cells: corners nearer than this to a line lie on it.
constexpr double OnLine = 1e-12;
// Squared cells: how far a border that is straightened first may move.
constexpr double ToleranceOfSteps = 1.0;
constexpr double Infinite = 1e300;

bool IsIn(const lms3dPoint2& p, const std::array<lms3dPoint2, 3>& triangle, int orientation)
{
  for (int i = 0; i < 3; ++i)
  {
    if (lms3dGetOrientation(triangle[i], triangle[(i + 1) % 3], p) * orientation < 0)
    {
      return false;
    }
  }
  return true;
}
} // namespace

lms3dOutlineSimplifier::lms3dOutlineSimplifier(const lms3dRegion& region,
  const std::vector<lms3dLoop>& loops, const std::vector<bool>& isFixed, double tolerance,
  double reach)
  : Region(region)
  , IsFixed(isFixed)
  , Tolerance(tolerance * tolerance)
  , Reach(reach)
  , Cut(region, CountCorners(loops))
{
  this->Link(loops);
}

void lms3dOutlineSimplifier::Link(const std::vector<lms3dLoop>& loops)
{
  for (const lms3dLoop& loop : loops)
  {
    const auto first = static_cast<Corner>(this->Points.size());
    const auto size = static_cast<Corner>(loop.size());
    this->FirstOfLoop.push_back(first);
    this->SizeOfLoop.push_back(size);
    for (Corner i = 0; i < size; ++i)
    {
      this->Points.push_back(loop[i]);
      this->Next.push_back(first + (i + 1) % size);
      this->Previous.push_back(first + (i + size - 1) % size);
    }
  }
  this->Buckets.Fill(this->Points);
  this->NextOriginal = this->Next;
  this->Versions.assign(this->Points.size(), 0);
  this->IsGone.assign(this->Points.size(), false);
}

// The square of the largest distance of a corner, and of those that went beside it, from the line
// that would take their place.
double lms3dOutlineSimplifier::GetCost(Corner corner) const
{
  const Corner from = this->Previous[corner];
  const Corner to = this->Next[corner];
  const lms3dSegment2 line(this->Points[from], this->Points[to]);
  double cost = 0.0;
  for (Corner original = this->NextOriginal[from]; original != to && cost <= this->Tolerance;
       original = this->NextOriginal[original])
  {
    cost = std::max(cost, line.GetSquaredDistance(this->Points[original]));
  }
  return this->IsFixed[corner] && cost > OnLine ? Infinite : cost;
}

void lms3dOutlineSimplifier::Queue(Corner corner)
{
  const double cost = this->GetCost(corner);
  ++this->Versions[corner];
  if (cost <= this->Tolerance)
  {
    this->Candidates.Add({ cost, corner, this->Versions[corner] });
  }
}

bool lms3dOutlineSimplifier::IsEmpty(
  const std::array<lms3dPoint2, 3>& triangle, Corner corner) const
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
    return other == corner || other == this->Next[corner] || other == this->Previous[corner] ||
      !IsIn(point, triangle, orientation);
  };
  return this->Buckets.AllOf(triangle, isFree);
}

// A corner between its neighbours.
std::array<lms3dPoint2, 3> lms3dOutlineSimplifier::GetTriangle(Corner corner) const
{
  return { this->Points[this->Previous[corner]], this->Points[corner],
    this->Points[this->Next[corner]] };
}

bool lms3dOutlineSimplifier::MayGo(Corner corner) const
{
  const std::array<lms3dPoint2, 3> triangle = this->GetTriangle(corner);
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  if (orientation == 0)
  {
    return true;
  }
  if (lms3dSegment2(triangle[0], triangle[2]).GetSquaredDistance(triangle[1]) <= OnLine)
  {
    return this->IsEmpty(triangle, corner);
  }
  return (orientation > 0 ? this->Cut.MayCut(triangle, this->Previous[corner], corner)
                          : this->MayGain(triangle)) &&
    this->IsEmpty(triangle, corner);
}

bool lms3dOutlineSimplifier::MayGain(const std::array<lms3dPoint2, 3>& triangle) const
{
  const lms3dCellBox box = lms3dGetTouchedBox(triangle);
  return (!this->Region.HasAny(&lms3dRasterBlock::Passed, box) && this->Region.HasBlocks(box)) ||
    lms3dForTouchedStrips(triangle,
      [&](const lms3dCellStrip& strip)
      {
        return this->Region.HasBlocks(strip) &&
          !this->Region.HasAny(&lms3dRasterBlock::Passed, strip);
      });
}

void lms3dOutlineSimplifier::Remove(Corner corner)
{
  const Corner previous = this->Previous[corner];
  const Corner next = this->Next[corner];
  this->Cut.Join(this->GetTriangle(corner), previous, corner);
  this->IsGone[corner] = true;
  this->Buckets.Remove(corner);
  this->Next[previous] = next;
  this->Previous[next] = previous;
}

// Takes out the steps of borders that are not along an axis, corner by corner, before the corners
// that are left go in order of their costs.
void lms3dOutlineSimplifier::RemoveSteps()
{
  const auto count = static_cast<Corner>(this->Points.size());
  for (Corner corner = 0; corner < count; ++corner)
  {
    const bool isTriangle = this->Next[this->Next[corner]] == this->Previous[corner];
    if (!isTriangle && this->GetCost(corner) <= ToleranceOfSteps && this->MayGo(corner))
    {
      this->Remove(corner);
    }
  }
}

void lms3dOutlineSimplifier::FindCandidates()
{
  const auto count = static_cast<Corner>(this->Points.size());
  for (Corner corner = 0; corner < count; ++corner)
  {
    const double cost = this->IsGone[corner] ? Infinite : this->GetCost(corner);
    if (cost <= this->Tolerance)
    {
      this->Candidates.AddFirst({ cost, corner, 0 });
    }
  }
  this->Candidates.SortFirst();
}

std::vector<lms3dLoop> lms3dOutlineSimplifier::Simplify()
{
  this->RemoveSteps();
  this->Cut.SetReach(this->Reach);
  this->FindCandidates();
  while (!this->Candidates.IsEmpty())
  {
    const lms3dCornerCandidate candidate = this->Candidates.TakeNext();
    const Corner corner = candidate.Number;
    const bool isCurrent = !this->IsGone[corner] && candidate.Version == this->Versions[corner];
    const bool isTriangle = isCurrent && this->Next[this->Next[corner]] == this->Previous[corner];
    if (isCurrent && !isTriangle && this->MayGo(corner))
    {
      const Corner previous = this->Previous[corner];
      const Corner next = this->Next[corner];
      this->Remove(corner);
      this->Queue(previous);
      this->Queue(next);
    }
  }
  return this->GetLoops();
}

std::vector<lms3dLoop> lms3dOutlineSimplifier::GetLoops() const
{
  std::vector<lms3dLoop> loops;
  for (std::size_t i = 0; i < this->FirstOfLoop.size(); ++i)
  {
    lms3dLoop loop;
    for (Corner corner = this->FirstOfLoop[i]; corner < this->FirstOfLoop[i] + this->SizeOfLoop[i];
         ++corner)
    {
      if (!this->IsGone[corner])
      {
        loop.push_back(this->Points[corner]);
      }
    }
    loops.push_back(loop);
  }
  return loops;
}
