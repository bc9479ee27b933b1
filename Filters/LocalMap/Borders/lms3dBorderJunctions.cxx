// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderJunctions.h"

#include "LocalMap/Borders/lms3dCreaseIntersection.h"

#include <algorithm>

namespace
{
using Gates = lms3dBorderGates;

// The cosine of the widest cell that junctions slide in.
constexpr double WideCosine = 0.6;
// How far the junctions of a cell that holds several stand apart, as a share of the cell.
constexpr double Apart = 0.06;
constexpr int AllCorners = 15;

// From the middle of a cell towards the middle of some of its corners.
lms3dPoint2 GetOffset(int corners)
{
  constexpr double X[4] = { -1.0, -1.0, 1.0, 1.0 };
  constexpr double Y[4] = { -1.0, 1.0, 1.0, -1.0 };
  lms3dPoint2 offset = { 0.0, 0.0 };
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (corners >> i & 1)
    {
      offset[0] += Apart * X[i];
      offset[1] += Apart * Y[i];
      ++count;
    }
  }
  return { offset[0] / count, offset[1] / count };
}
} // namespace

lms3dBorderJunctions::lms3dBorderJunctions(const lms3dBeamSphere& sphere,
  const lms3dPatches& patches, const lms3dBorderGates& gates, const lms3dBorderChains& chains,
  const lms3dBorderRanges& borderRanges)
  : Sphere(sphere)
  , Patches(patches)
  , Gates(gates)
  , Chains(chains)
  , BorderRanges(borderRanges)
{
  this->FindJunctions();
}

lms3dBorderJunctions::Junction lms3dBorderJunctions::GetEndJunction(int edge) const
{
  int corner;
  const Cell cell = this->Gates.GetEndCell(edge, corner);
  return { cell.LowerLeft, this->GetGroup(cell, corner) };
}

// The corners of a cell that neither a cut nor a step keeps apart from one of them.
std::uint8_t lms3dBorderJunctions::GetGroup(const Cell& cell, int own) const
{
  const auto isApart = [&](int corner)
  {
    const int gate = this->Gates.GetCellGate(cell, corner);
    return gate == Gates::NoGate ? this->Patches.Labels[cell.Corners[corner]] < 0
                                 : this->Gates.GetGate(2 * gate).Kind != Gates::Crease;
  };
  int corners = 1 << own;
  for (int corner = own; !isApart(corner) && corners != AllCorners; corner = (corner + 1) % 4)
  {
    corners |= 1 << (corner + 1) % 4;
  }
  for (int corner = (own + 3) % 4; !isApart(corner) && corners != AllCorners;
       corner = (corner + 3) % 4)
  {
    corners |= 1 << corner;
  }
  return static_cast<std::uint8_t>(corners);
}

// Both sides of a chain that is no step end in the same junctions.
std::array<lms3dBorderJunctions::Junction, 4> lms3dBorderJunctions::GetEndJunctions(
  const Chain& chain) const
{
  const int first = chain.Edges.front();
  const int last = chain.Edges.back();
  const Junction start = this->GetEndJunction(this->Chains.GetBefore(first));
  const Junction end = this->GetEndJunction(last);
  return this->Gates.GetGate(first).Kind == Gates::Offset
    ? std::array<Junction, 4>{ start, this->GetEndJunction(Gates::GetTwin(first)), end,
        this->GetEndJunction(this->Chains.GetBefore(Gates::GetTwin(last))) }
    : std::array<Junction, 4>{ start, start, end, end };
}

void lms3dBorderJunctions::FindJunctions()
{
  const std::vector<Chain>& chains = this->Chains.GetChains();
  std::vector<std::array<Junction, 4>> ends(chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (!chains[i].IsClosed)
    {
      ends[i] = this->GetEndJunctions(chains[i]);
      this->Junctions.insert(this->Junctions.end(), ends[i].begin(), ends[i].end());
    }
  }
  std::sort(this->Junctions.begin(), this->Junctions.end());
  const auto isSame = [](const Junction& a, const Junction& b) { return !(a < b) && !(b < a); };
  this->Junctions.erase(
    std::unique(this->Junctions.begin(), this->Junctions.end(), isSame), this->Junctions.end());
  const auto find = [&](const Junction& junction)
  {
    return static_cast<std::int32_t>(
      std::lower_bound(this->Junctions.begin(), this->Junctions.end(), junction) -
      this->Junctions.begin());
  };
  this->Ends.resize(chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (!chains[i].IsClosed)
    {
      std::transform(ends[i].begin(), ends[i].end(), this->Ends[i].begin(), find);
    }
  }
}

std::vector<lms3dMapVertex> lms3dBorderJunctions::Locate() const
{
  std::vector<lms3dMapVertex> vertices;
  vertices.reserve(this->Junctions.size());
  for (const Junction& junction : this->Junctions)
  {
    const Cell cell = this->Gates.GetCell(junction.LowerLeft);
    vertices.push_back(this->BorderRanges.GetVertexInCell(
      cell, junction.Corners, this->SlideToCreases(junction, cell)));
  }
  return vertices;
}

// From the middle of the cell to the nearest point where the planes of its creases meet. Junctions of
// one cell that a step keeps apart slide together, so that the band between them stays even.
std::array<double, 4> lms3dBorderJunctions::SlideToCreases(
  const Junction& junction, const Cell& cell) const
{
  bool hasOffset = false;
  for (int i = 0; i < 4; ++i)
  {
    hasOffset |= this->IsOffset(cell, i);
  }
  lms3dCreaseIntersection slide;
  for (int i = 0; i < 4; ++i)
  {
    const int gate = this->Gates.GetCellGate(cell, i);
    if (gate != Gates::NoGate && this->Gates.GetGate(2 * gate).Kind == Gates::Crease &&
      (hasOffset || (junction.Corners >> i & 1)))
    {
      slide.AddCrease(this->GetDifferences(cell, i));
    }
  }
  const lms3dPoint2 offset = GetOffset(junction.Corners);
  const bool isFree = !this->HasFallback(cell.LowerLeft, 1) && !this->IsWide(cell);
  if (!hasOffset)
  {
    slide.Move(offset);
  }
  if (isFree)
  {
    slide.Run();
  }
  if (hasOffset)
  {
    slide.Move(offset);
  }
  return slide.GetWeights();
}

// At the corners of a cell, the differences between the planes on both sides of one of its gates.
std::array<double, 4> lms3dBorderJunctions::GetDifferences(const Cell& cell, int corner) const
{
  const auto getPlane = [&](int i) -> const lms3dVector&
  { return this->Patches.Patches[this->Patches.Labels[cell.Corners[i]]].Plane.Q; };
  const lms3dVector difference = lms3dSubtract(getPlane(corner), getPlane((corner + 1) % 4));
  std::array<double, 4> differences;
  for (int i = 0; i < 4; ++i)
  {
    differences[i] = lms3dDot(difference, this->Sphere.GetDirection(cell.Corners[i]));
  }
  return differences;
}

// In cells as wide, a junction must not go far.
bool lms3dBorderJunctions::IsWide(const Cell& cell) const
{
  const auto getCosine = [&](int a, int b)
  {
    return lms3dDot(
      this->Sphere.GetDirection(cell.Corners[a]), this->Sphere.GetDirection(cell.Corners[b]));
  };
  return getCosine(0, 2) < WideCosine || getCosine(1, 3) < WideCosine;
}

bool lms3dBorderJunctions::IsOffset(const Cell& cell, int corner) const
{
  const int gate = this->Gates.GetCellGate(cell, corner);
  return gate != Gates::NoGate && this->Gates.GetGate(2 * gate).Kind == Gates::Offset;
}

// At the start of a chain or at its end.
lms3dBorderJunctions::GridIndex lms3dBorderJunctions::GetEndCell(const Chain& chain, int end) const
{
  int corner;
  return this->Gates
    .GetEndCell(end == 0 ? this->Chains.GetBefore(chain.Edges.front()) : chain.Edges.back(), corner)
    .LowerLeft;
}

bool lms3dBorderJunctions::HasFallback(GridIndex cell, int level) const
{
  const auto found = this->Fallbacks.find(cell);
  return found != this->Fallbacks.end() && found->second >= level;
}

bool lms3dBorderJunctions::IsEndOfSlit(std::size_t chain, int end) const
{
  const std::int32_t junction = this->Ends[chain][2 * end];
  return this->Gates.GetGate(this->Chains.GetChains()[chain].Edges.front()).Kind ==
    Gates::DepthStep &&
    this->Junctions[junction].Corners == AllCorners;
}

// A cut may end within a surface, as a slit. Beyond the slit another patch has both junctions too, and
// where it has an edge between them, that must not be the edge of this patch as well.
bool lms3dBorderJunctions::NeedsBendAtSlit(std::size_t chain) const
{
  const int edge = this->Chains.GetChains()[chain].Edges.front();
  if (this->Gates.GetGate(edge).Kind != Gates::DepthStep)
  {
    return false;
  }
  const Junction& start = this->Junctions[this->GetStart(chain, 0)];
  const Junction& end = this->Junctions[this->GetEnd(chain, 0)];
  if (start.Corners == AllCorners && end.Corners == AllCorners)
  {
    return true;
  }
  const std::int32_t own = this->Gates.GetPatch(edge);
  const std::vector<std::int32_t> atStart = this->GetOthers(start, own);
  const std::vector<std::int32_t> atEnd = this->GetOthers(end, own);
  return std::find_first_of(atStart.begin(), atStart.end(), atEnd.begin(), atEnd.end()) !=
    atStart.end();
}

// The patches that share a junction with one.
std::vector<std::int32_t> lms3dBorderJunctions::GetOthers(
  const Junction& junction, std::int32_t own) const
{
  const Cell cell = this->Gates.GetCell(junction.LowerLeft);
  std::vector<std::int32_t> others;
  for (int i = 0; i < 4; ++i)
  {
    const std::int32_t label = this->Patches.Labels[cell.Corners[i]];
    if (label >= 0 && label != own && (junction.Corners >> i & 1))
    {
      others.push_back(label);
    }
  }
  return others;
}

// The junctions of the groups after each step of a cell, counter-clockwise; none where a cut or a miss
// leaves the cell open.
std::vector<std::int32_t> lms3dBorderJunctions::GetHole(std::int32_t first) const
{
  const std::int32_t lowerLeft = this->Junctions[first].LowerLeft;
  const Cell cell = this->Gates.GetCell(lowerLeft);
  std::vector<std::int32_t> hole;
  for (int corner = 3; corner >= 0; --corner)
  {
    const int gate = this->Gates.GetCellGate(cell, corner);
    if (this->Patches.Labels[cell.Corners[corner]] < 0 ||
      (gate != Gates::NoGate && this->Gates.GetGate(2 * gate).Kind == Gates::DepthStep))
    {
      return {};
    }
    if (this->IsOffset(cell, corner))
    {
      // The group of the corner before this step, clockwise.
      std::int32_t i = first;
      while (i < this->GetNumberOfJunctions() && this->Junctions[i].LowerLeft == lowerLeft &&
        !(this->Junctions[i].Corners >> corner & 1))
      {
        ++i;
      }
      hole.push_back(i);
    }
  }
  return hole;
}

bool lms3dBorderJunctions::IsFirstOfCell(std::int32_t junction) const
{
  return junction == 0 ||
    this->Junctions[junction - 1].LowerLeft != this->Junctions[junction].LowerLeft;
}
