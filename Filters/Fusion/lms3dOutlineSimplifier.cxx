// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dOutlineSimplifier.h"

#include "Fusion/lms3dRasterRows.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace
{
// Squared cells: corners nearer than this to a line lie on it.
constexpr double OnLine = 1e-12;
constexpr double Infinite = 1e300;

double GetSquaredDistance(const lms3dPoint2& p, const lms3dPoint2& a, const lms3dPoint2& b)
{
  const double du = b[0] - a[0];
  const double dv = b[1] - a[1];
  const double square = du * du + dv * dv;
  const double share =
    square > 0.0 ? std::clamp(((p[0] - a[0]) * du + (p[1] - a[1]) * dv) / square, 0.0, 1.0) : 0.0;
  const double u = p[0] - a[0] - share * du;
  const double v = p[1] - a[1] - share * dv;
  return u * u + v * v;
}

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

lms3dOutlineSimplifier::lms3dOutlineSimplifier(const lms3dRaster& region,
  const std::vector<lms3dLoop>& loops, const std::vector<bool>& isFixed, double tolerance)
  : Region(region)
  , IsFixed(isFixed)
  , Tolerance(tolerance * tolerance)
{
  this->Link(loops);
}

void lms3dOutlineSimplifier::Link(const std::vector<lms3dLoop>& loops)
{
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
  {
    const auto first = static_cast<Corner>(this->Points.size());
    const auto size = static_cast<Corner>(loops[loop].size());
    this->FirstOfLoop.push_back(first);
    this->SizeOfLoop.push_back(size);
    for (Corner i = 0; i < size; ++i)
    {
      this->Points.push_back(loops[loop][i]);
      this->Next.push_back(first + (i + 1) % size);
      this->Previous.push_back(first + (i + size - 1) % size);
      this->LoopOf.push_back(static_cast<int>(loop));
      this->Buckets.Add(first + i, loops[loop][i]);
    }
  }
  this->Versions.assign(this->Points.size(), 0);
  this->IsGone.assign(this->Points.size(), false);
}

// The square of the largest distance of a corner, and of those that went beside it, from the line that would take their place.
double lms3dOutlineSimplifier::GetCost(Corner corner) const
{
  const Corner from = this->Previous[corner];
  const Corner to = this->Next[corner];
  const int loop = this->LoopOf[corner];
  const Corner first = this->FirstOfLoop[loop];
  const Corner end = first + this->SizeOfLoop[loop];
  double cost = 0.0;
  Corner original = from;
  do
  {
    cost = std::max(
      cost, GetSquaredDistance(this->Points[original], this->Points[from], this->Points[to]));
    original = original + 1 < end ? original + 1 : first;
  } while (original != to && cost <= this->Tolerance);
  if (this->IsFixed[corner] && cost > OnLine)
  {
    return Infinite;
  }
  return cost;
}

void lms3dOutlineSimplifier::Queue(Corner corner)
{
  const double cost = this->GetCost(corner);
  ++this->Versions[corner];
  if (cost <= this->Tolerance)
  {
    this->Candidates.push({ cost, corner, this->Versions[corner] });
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
  const auto isFree = [&](Corner other)
  {
    const lms3dPoint2& point = this->Points[other];
    if (point[0] < box[0] || point[0] > box[1] || point[1] < box[2] || point[1] > box[3])
    {
      return true;
    }
    return other == corner || other == this->Next[corner] || other == this->Previous[corner] ||
      !IsIn(this->Points[other], triangle, orientation);
  };
  return this->Buckets.AllOf(triangle, isFree);
}

bool lms3dOutlineSimplifier::MayGo(Corner corner) const
{
  const std::array<lms3dPoint2, 3> triangle = { this->Points[this->Previous[corner]],
    this->Points[corner], this->Points[this->Next[corner]] };
  const int orientation = lms3dGetOrientation(triangle[0], triangle[1], triangle[2]);
  if (orientation == 0)
  {
    return true;
  }
  if (GetSquaredDistance(triangle[1], triangle[0], triangle[2]) <= OnLine)
  {
    return this->IsEmpty(triangle, corner);
  }
  return (orientation > 0 ? this->MayLose(triangle) : this->MayGain(triangle)) &&
    this->IsEmpty(triangle, corner);
}

bool lms3dOutlineSimplifier::MayLose(const std::array<lms3dPoint2, 3>& triangle) const
{
  return !this->Region.HasAny(&lms3dRasterBlock::Must, lms3dGetTouchedBox(triangle)) ||
    lms3dForCentreStrips(triangle,
      [&](const lms3dCellStrip& strip)
      { return !this->Region.HasAny(&lms3dRasterBlock::Must, strip); });
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
  this->IsGone[corner] = true;
  this->Buckets.Remove(corner, this->Points[corner]);
  this->Next[previous] = next;
  this->Previous[next] = previous;
  this->Queue(previous);
  this->Queue(next);
}

std::vector<lms3dLoop> lms3dOutlineSimplifier::Simplify()
{
  const auto count = static_cast<Corner>(this->Points.size());
  std::vector<Candidate> candidates;
  for (Corner corner = 0; corner < count; ++corner)
  {
    const double cost = this->GetCost(corner);
    if (cost <= this->Tolerance)
    {
      candidates.push_back({ cost, corner, 0 });
    }
  }
  this->Candidates = std::priority_queue<Candidate>(std::less<Candidate>(), std::move(candidates));
  while (!this->Candidates.empty())
  {
    const Candidate candidate = this->Candidates.top();
    this->Candidates.pop();
    const Corner corner = candidate.Number;
    const bool isCurrent = !this->IsGone[corner] && candidate.Version == this->Versions[corner];
    const bool isTriangle = isCurrent && this->Next[this->Next[corner]] == this->Previous[corner];
    if (isCurrent && !isTriangle && this->MayGo(corner))
    {
      this->Remove(corner);
    }
  }
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
