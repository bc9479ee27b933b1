// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dTriangulator.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t WorkPerCorner = 2000;
constexpr std::size_t WorkPerCornerIfExhausted = 10;
constexpr std::size_t WorkAllowance = 1000000;
constexpr std::size_t WorkPerCheck = 100000;
constexpr std::int32_t LongWalk = 64;
} // namespace

bool lms3dTriangulator::Cut(const std::vector<lms3dVector>& corners, const KeepGoing& keepGoing)
{
  this->Triangles.clear();
  if (corners.size() < 3 || !this->Polygon.Project(corners))
  {
    return true;
  }
  if (this->Polygon.IsConvex() && this->MakeFan())
  {
    return true;
  }
  this->Triangles.clear();
  return this->ClipEars(keepGoing);
}

double lms3dTriangulator::GetTurn(std::int32_t corner) const
{
  return this->Polygon.GetTurn(this->Previous[corner], corner, this->Next[corner]);
}

double lms3dTriangulator::GetMinimumTurn(std::int32_t corner) const
{
  return this->Polygon.GetMinimumTurn(this->Previous[corner], corner, this->Next[corner]);
}

bool lms3dTriangulator::IsStraight(std::int32_t corner) const
{
  return std::abs(this->GetTurn(corner)) <= this->GetMinimumTurn(corner);
}

// A fan has a degenerate triangle if a neighbour of its shared corner is straight. That triangle is
// dropped, and the neighbour would no longer be a vertex of the surface.
std::int32_t lms3dTriangulator::FindFanCorner() const
{
  const auto isStraight = [this](std::int32_t corner)
  {
    const std::int32_t previous = this->Polygon.GetPrevious(corner);
    const std::int32_t next = this->Polygon.GetNext(corner);
    return this->Polygon.GetTurn(previous, corner, next) <=
      this->Polygon.GetMinimumTurn(previous, corner, next);
  };
  const std::int32_t count = static_cast<std::int32_t>(this->Polygon.GetPoints().size());
  const std::int32_t preferred = this->FanCorner == FIRST_CORNER ? 0 : count - 1;
  std::int32_t corner = preferred;
  for (std::int32_t i = 0; i < count; ++i)
  {
    if (!isStraight(this->Polygon.GetPrevious(corner)) &&
      !isStraight(this->Polygon.GetNext(corner)))
    {
      return corner;
    }
    corner = this->Polygon.GetNext(corner);
  }
  return preferred;
}

// Rounding can hide the reflex corners of a smooth outline. The fan shows them.
bool lms3dTriangulator::MakeFan()
{
  const std::int32_t shared = this->FindFanCorner();
  std::int32_t a = this->Polygon.GetNext(shared);
  for (std::int32_t b = this->Polygon.GetNext(a); b != shared; b = this->Polygon.GetNext(b))
  {
    const double turn = this->Polygon.GetTurn(shared, a, b);
    if (turn > 0.0)
    {
      this->Triangles.push_back({ shared, a, b });
    }
    else if (turn < -this->Polygon.GetMinimumTurn(shared, a, b))
    {
      return false;
    }
    a = b;
  }
  return true;
}

void lms3dTriangulator::LinkCorners()
{
  const std::int32_t count = static_cast<std::int32_t>(this->Polygon.GetPoints().size());
  this->Next.resize(this->Polygon.GetPoints().size());
  this->Previous.resize(this->Polygon.GetPoints().size());
  for (std::int32_t i = 0; i < count; ++i)
  {
    this->Next[i] = this->Polygon.GetNext(i);
    this->Previous[i] = this->Polygon.GetPrevious(i);
  }
}

// An ear that contains any corner contains one that is not convex.
void lms3dTriangulator::BuildGrid()
{
  std::vector<std::int32_t> notConvex;
  for (std::size_t i = 0; i < this->Polygon.GetPoints().size(); ++i)
  {
    const std::int32_t corner = static_cast<std::int32_t>(i);
    if (this->GetTurn(corner) <= this->GetMinimumTurn(corner))
    {
      notConvex.push_back(corner);
    }
  }
  this->Grid.Build(this->Polygon.GetPoints(), notConvex);
}

bool lms3dTriangulator::MayContinue(const KeepGoing& keepGoing)
{
  if (this->Work < this->NextCheck)
  {
    return true;
  }
  this->NextCheck = this->Work + WorkPerCheck;
  return !keepGoing || keepGoing();
}

void lms3dTriangulator::BeginClipping()
{
  this->LinkCorners();
  this->BuildGrid();
  this->Work = 0;
  this->MaximumWork = WorkAllowance + WorkPerCorner * this->Polygon.GetPoints().size();
  this->NextCheck = WorkPerCheck;
}

bool lms3dTriangulator::ClipEars(const KeepGoing& keepGoing)
{
  this->BeginClipping();
  bool isSimple = true;
  bool stepsBack = false;
  int requirement = NO_CORNER_TOUCHES;
  std::int32_t corner = 0;
  std::int32_t failures = 0;
  for (std::size_t left = this->Polygon.GetPoints().size(); left > 2;)
  {
    if (!this->MayContinue(keepGoing))
    {
      this->Triangles.clear();
      return false;
    }
    requirement = std::max(requirement, this->GetAffordableRequirement());
    if (this->IsEar(corner, requirement))
    {
      // A corner on a straight line can be clipped under any requirement.
      isSimple = isSimple && (requirement < CONVEX || this->IsStraight(corner));
      this->Clip(corner);
      --left;
      requirement = this->IsExhausted() ? requirement : NO_CORNER_TOUCHES;
      // Clipping every other corner gives compact triangles. Next to a clipped corner the turns
      // have changed: if ears are rare, the next one is there.
      stepsBack = failures > LongWalk || (stepsBack && failures <= 1);
      corner = stepsBack ? this->Previous[corner] : this->Next[this->Next[corner]];
      failures = 0;
      continue;
    }
    corner = this->Next[corner];
    if (static_cast<std::size_t>(++failures) == left)
    {
      corner = this->Next[corner];
      ++requirement;
      failures = 0;
    }
  }
  return isSimple;
}

int lms3dTriangulator::GetAffordableRequirement() const
{
  if (!this->IsExhausted())
  {
    return NO_CORNER_TOUCHES;
  }
  const std::size_t extra = WorkPerCornerIfExhausted * this->Polygon.GetPoints().size();
  return this->Work < this->MaximumWork + extra ? CONVEX : ANY;
}

bool lms3dTriangulator::IsEar(std::int32_t corner, int requirement)
{
  ++this->Work;
  if (this->IsStraight(corner) || requirement == ANY)
  {
    return true;
  }
  return this->GetTurn(corner) > 0.0 &&
    (requirement == CONVEX || this->IsFree(corner, requirement == NO_CORNER_INSIDE));
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
  if (!this->IsExhausted())
  {
    this->Work += this->Grid.Remove(corner, this->Polygon.GetPoints()[corner]);
  }
}

// Corners at the same point as a corner of the ear do not count: they are ends of a bridge to a
// hole.
bool lms3dTriangulator::IsFree(std::int32_t corner, bool mayTouch)
{
  const std::int32_t a = this->Previous[corner];
  const std::int32_t c = this->Next[corner];
  const lms3dFlatPolygon::Point& p = this->Polygon.GetPoints()[a];
  const lms3dFlatPolygon::Point& q = this->Polygon.GetPoints()[corner];
  const lms3dFlatPolygon::Point& r = this->Polygon.GetPoints()[c];
  const lms3dFlatPolygon::Point minimum = { std::min({ p[0], q[0], r[0] }),
    std::min({ p[1], q[1], r[1] }) };
  const lms3dFlatPolygon::Point maximum = { std::max({ p[0], q[0], r[0] }),
    std::max({ p[1], q[1], r[1] }) };
  const double minimumTurn = this->GetMinimumTurn(corner);
  return this->Grid.AllOf(minimum, maximum, this->Work,
    [&](std::int32_t other)
    {
      const lms3dFlatPolygon::Point& point = this->Polygon.GetPoints()[other];
      const double inside = std::min({ this->Polygon.GetTurn(a, corner, other),
        this->Polygon.GetTurn(corner, c, other), this->Polygon.GetTurn(c, a, other) });
      return point == p || point == q || point == r || inside < -minimumTurn ||
        (inside <= minimumTurn && mayTouch);
    });
}
