// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dTriangulator.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t WorkPerCorner = 2000;
constexpr std::size_t WorkOfAny = 1000000;

lms3dVector GetFanNormal(const std::vector<lms3dVector>& corners, std::size_t i)
{
  return lms3dCross(
    lms3dSubtract(corners[i], corners[0]), lms3dSubtract(corners[i + 1], corners[0]));
}

// Newell's normal is the sum over a fan. Where a polygon crosses itself so that the sum is nothing,
// the largest triangle of the fan tells the plane.
lms3dVector GetNormal(const std::vector<lms3dVector>& corners)
{
  lms3dVector sum = { 0, 0, 0 };
  lms3dVector largest = { 0, 0, 0 };
  double total = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const lms3dVector normal = GetFanNormal(corners, i);
    total += std::sqrt(lms3dDot(normal, normal));
    largest = lms3dDot(normal, normal) > lms3dDot(largest, largest) ? normal : largest;
    sum = lms3dAdd(sum, normal);
  }
  constexpr double rounding = 1e-12;
  return std::sqrt(lms3dDot(sum, sum)) > rounding * total ? sum : largest;
}

// The corners of a straight line that is not along an axis are beside it by their rounding.
double GetLeastTurn(const std::vector<lms3dVector>& corners, int first, int second)
{
  constexpr double rounding = 1e-14;
  double farthest = 0.0;
  double size = 0.0;
  for (const lms3dVector& corner : corners)
  {
    farthest = std::max({ farthest, std::abs(corner[first]), std::abs(corner[second]) });
    size = std::max({ size, std::abs(corner[first] - corners[0][first]),
      std::abs(corner[second] - corners[0][second]) });
  }
  return rounding * farthest * size;
}
} // namespace

bool lms3dTriangulator::Cut(const std::vector<lms3dVector>& corners)
{
  this->Triangles.clear();
  if (corners.size() < 3 || !this->Flatten(corners))
  {
    return true;
  }
  if (this->IsConvex())
  {
    this->Fan();
    return true;
  }
  return this->ClipEars();
}

/// Drops the axis that the normal is nearest to; false where there is no normal.
bool lms3dTriangulator::Flatten(const std::vector<lms3dVector>& corners)
{
  const lms3dVector normal = GetNormal(corners);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
  }
  const int first = normal[axis] > 0.0 ? (axis + 1) % 3 : (axis + 2) % 3;
  const int second = normal[axis] > 0.0 ? (axis + 2) % 3 : (axis + 1) % 3;
  this->Points.clear();
  for (const lms3dVector& corner : corners)
  {
    this->Points.push_back(
      { corner[first] - corners[0][first], corner[second] - corners[0][second] });
  }
  this->LeastTurn = GetLeastTurn(corners, first, second);
  return normal[axis] != 0.0;
}

double lms3dTriangulator::GetTurn(std::int32_t a, std::int32_t b, std::int32_t c) const
{
  const FlatPoint& p = this->Points[a];
  const FlatPoint& q = this->Points[b];
  const FlatPoint& r = this->Points[c];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

double lms3dTriangulator::GetTurn(std::int32_t corner) const
{
  return this->GetTurn(this->Previous[corner], corner, this->Next[corner]);
}

bool lms3dTriangulator::IsStraight(std::int32_t corner) const
{
  return std::abs(this->GetTurn(corner)) <= this->LeastTurn;
}

// Turns left everywhere, and goes around once: to the right and back.
bool lms3dTriangulator::IsConvex() const
{
  const std::int32_t count = static_cast<std::int32_t>(this->Points.size());
  int changes = 0;
  double lastStep = 0.0;
  double firstStep = 0.0;
  for (std::int32_t a = 0; a < count; ++a)
  {
    const std::int32_t b = a + 1 < count ? a + 1 : 0;
    const std::int32_t c = b + 1 < count ? b + 1 : 0;
    if (this->GetTurn(a, b, c) < -this->LeastTurn)
    {
      return false;
    }
    const double step = this->Points[b][0] - this->Points[a][0];
    if (step != 0.0)
    {
      changes += step * lastStep < 0.0 ? 1 : 0;
      lastStep = step > 0.0 ? 1.0 : -1.0;
      firstStep = firstStep == 0.0 ? lastStep : firstStep;
    }
  }
  return changes + (firstStep * lastStep < 0.0 ? 1 : 0) <= 2;
}

void lms3dTriangulator::Fan()
{
  const std::int32_t count = static_cast<std::int32_t>(this->Points.size());
  for (std::int32_t i = 1; i + 1 < count; ++i)
  {
    if (this->GetTurn(0, i, i + 1) > 0.0)
    {
      this->Triangles.push_back({ 0, i, i + 1 });
    }
  }
}

// --- Ears -----------------------------------------------------------------------------------------

bool lms3dTriangulator::ClipEars()
{
  const std::int32_t count = static_cast<std::int32_t>(this->Points.size());
  this->Next.resize(this->Points.size());
  this->Previous.resize(this->Points.size());
  for (std::int32_t i = 0; i < count; ++i)
  {
    this->Next[i] = (i + 1) % count;
    this->Previous[i] = (i + count - 1) % count;
  }
  this->BuildGrid();
  this->WorkLeft = WorkOfAny + WorkPerCorner * this->Points.size();

  bool isSimple = true;
  int care = NO_CORNER_TOUCHES;
  std::int32_t corner = 0;
  std::int32_t inVain = 0;
  for (std::int32_t left = count; left > 2;)
  {
    care = this->WorkLeft == 0 ? std::max<int>(care, CONVEX) : care;
    if (this->IsEar(corner, care))
    {
      // A corner on a straight line is no loss, whatever the care.
      isSimple = isSimple && (care < CONVEX || this->IsStraight(corner));
      this->Clip(corner);
      --left;
      care = NO_CORNER_TOUCHES;
      inVain = 0;
    }
    else if (++inVain == left)
    {
      ++care;
      inVain = 0;
    }
    // Every other corner, so that triangles come out compact.
    corner = this->Next[inVain == 0 ? this->Next[corner] : corner];
  }
  return isSimple;
}

bool lms3dTriangulator::IsEar(std::int32_t corner, int care)
{
  this->WorkLeft -= this->WorkLeft > 0 ? 1 : 0;
  if (this->IsStraight(corner) || care == ANY)
  {
    return true;
  }
  return this->GetTurn(corner) > 0.0 &&
    (care == CONVEX || this->IsFree(corner, care == NO_CORNER_INSIDE));
}

void lms3dTriangulator::Clip(std::int32_t corner)
{
  const std::int32_t previous = this->Previous[corner];
  const std::int32_t next = this->Next[corner];
  const double turn = this->GetTurn(corner);
  if (turn > 0.0)
  {
    this->Triangles.push_back({ previous, corner, next });
  }
  else if (turn < 0.0)
  {
    this->Triangles.push_back({ previous, next, corner });
  }
  this->Next[previous] = next;
  this->Previous[next] = previous;
  this->Grid.Remove(corner, this->Points[corner]);
}

// Corners at the same place as the ear's are the two ends of a bridge to a hole.
bool lms3dTriangulator::IsFree(std::int32_t corner, bool mayTouch)
{
  const std::int32_t a = this->Previous[corner];
  const std::int32_t c = this->Next[corner];
  const FlatPoint& p = this->Points[a];
  const FlatPoint& q = this->Points[corner];
  const FlatPoint& r = this->Points[c];
  const FlatPoint least = { std::min({ p[0], q[0], r[0] }), std::min({ p[1], q[1], r[1] }) };
  const FlatPoint most = { std::max({ p[0], q[0], r[0] }), std::max({ p[1], q[1], r[1] }) };
  return this->Grid.AllOf(least, most, this->WorkLeft,
    [&](std::int32_t other)
    {
      const FlatPoint& point = this->Points[other];
      const double inside = std::min({ this->GetTurn(a, corner, other),
        this->GetTurn(corner, c, other), this->GetTurn(c, a, other) });
      return point == p || point == q || point == r || inside < -this->LeastTurn ||
        (inside <= this->LeastTurn && mayTouch);
    });
}

// An ear that holds any corner holds one that is not convex.
void lms3dTriangulator::BuildGrid()
{
  std::vector<std::int32_t> notConvex;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const std::int32_t corner = static_cast<std::int32_t>(i);
    if (this->GetTurn(corner) <= this->LeastTurn)
    {
      notConvex.push_back(corner);
    }
  }
  this->Grid.Build(this->Points, notConvex);
}
