// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderJunctions.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace
{
using Gates = lms3dBorderGates;

constexpr int AllCorners = 15;
} // namespace

lms3dBorderJunctions::lms3dBorderJunctions(const lms3dBeamSphere& sphere,
  const lms3dPatches& patches, const lms3dBorderGates& gates, const lms3dBorderChains& chains,
  const lms3dBorderRanges& borderRanges)
  : Patches(patches)
  , Gates(gates)
  , Chains(chains)
  , Placement(sphere, patches, gates, borderRanges)
{
  this->FindJunctions();
}

lms3dBorderJunctions::Junction lms3dBorderJunctions::GetEndJunction(int edge) const
{
  int corner;
  const Cell cell = this->Gates.GetEndCell(edge, corner);
  return { cell.LowerLeft, this->GetGroup(cell, corner) };
}

// The corners of a cell that neither a depth step nor an offset separates from one of them, as
// bits.
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

// Except along offsets, both sides of a chain end in the same junctions.
std::array<lms3dBorderJunctions::Junction, 4> lms3dBorderJunctions::GetEndJunctions(
  std::size_t chain) const
{
  const Chain& edges = this->Chains.GetChains()[chain];
  const int first = edges.Edges.front();
  const int last = edges.Edges.back();
  const Junction start = this->GetEndJunction(this->Chains.GetBefore(first));
  const Junction end = this->GetEndJunction(last);
  return this->Chains.GetKind(chain) == Gates::Offset
    ? std::array<Junction, 4>{ start, this->GetEndJunction(Gates::GetTwin(first)), end,
        this->GetEndJunction(this->Chains.GetBefore(Gates::GetTwin(last))) }
    : std::array<Junction, 4>{ start, start, end, end };
}

void lms3dBorderJunctions::FindJunctions()
{
  const std::vector<Chain>& chains = this->Chains.GetChains();
  std::vector<std::array<Junction, 4>> ends(chains.size());
  tbb::parallel_for(std::size_t(0), chains.size(),
    [&](std::size_t i)
    {
      if (!chains[i].IsClosed)
      {
        ends[i] = this->GetEndJunctions(i);
      }
    });
  this->Junctions.reserve(4 * chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    // Except along offsets, every second one is as the one before.
    const std::size_t step = this->Chains.GetKind(i) == Gates::Offset ? 1 : 2;
    for (std::size_t j = 0; !chains[i].IsClosed && j < ends[i].size(); j += step)
    {
      this->Junctions.push_back(ends[i][j]);
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
  tbb::parallel_for(std::size_t(0), chains.size(),
    [&](std::size_t i)
    {
      if (!chains[i].IsClosed)
      {
        std::transform(ends[i].begin(), ends[i].end(), this->Ends[i].begin(), find);
      }
    });
}

void lms3dBorderJunctions::Locate(std::vector<lms3dMapVertex>& vertices) const
{
  const bool isFirst = vertices.empty();
  vertices.resize(this->Junctions.size());
  tbb::parallel_for(std::size_t(0), vertices.size(),
    [&](std::size_t i)
    {
      const Junction& junction = this->Junctions[i];
      const bool staysInMiddle = this->HasFallback(junction.LowerLeft, JunctionsStay);
      if (isFirst || staysInMiddle)
      {
        vertices[i] = this->Placement.Locate(
          this->Gates.GetCell(junction.LowerLeft), junction.Corners, staysInMiddle);
      }
    });
}

// The cell at the start of a chain (0) or at its end (1).
lms3dBorderJunctions::GridIndex lms3dBorderJunctions::GetEndCell(const Chain& chain, int end) const
{
  int corner;
  return this->Gates
    .GetEndCell(end == 0 ? this->Chains.GetBefore(chain.Edges.front()) : chain.Edges.back(), corner)
    .LowerLeft;
}

void lms3dBorderJunctions::RaiseFallback(const Chain& chain)
{
  ++this->Fallbacks[this->GetEndCell(chain, 0)];
  ++this->Fallbacks[this->GetEndCell(chain, 1)];
}

bool lms3dBorderJunctions::HasFallback(GridIndex cell, int level) const
{
  const auto found = this->Fallbacks.find(cell);
  return found != this->Fallbacks.end() && found->second >= level;
}

bool lms3dBorderJunctions::HasFallback(const Chain& chain, int level) const
{
  return this->HasFallback(this->GetEndCell(chain, 0), level) ||
    this->HasFallback(this->GetEndCell(chain, 1), level);
}

bool lms3dBorderJunctions::IsEndOfSlit(std::size_t chain, int end) const
{
  return this->Chains.GetKind(chain) == Gates::DepthStep &&
    this->Junctions[this->Ends[chain][2 * end]].Corners == AllCorners;
}

// Beyond a slit, another patch can have both junctions, too. If that patch has an edge between
// them, this patch must not have the same edge.
bool lms3dBorderJunctions::NeedsBendAtSlit(std::size_t chain) const
{
  if (this->Chains.GetKind(chain) != Gates::DepthStep)
  {
    return false;
  }
  const Junction& start = this->Junctions[this->GetStart(chain, 0)];
  const Junction& end = this->Junctions[this->GetEnd(chain, 0)];
  if (start.Corners == AllCorners && end.Corners == AllCorners)
  {
    return true;
  }
  const std::int32_t own = this->Gates.GetPatch(this->Chains.GetChains()[chain].Edges.front());
  const std::vector<std::int32_t> atStart = this->GetOthers(start, own);
  const std::vector<std::int32_t> atEnd = this->GetOthers(end, own);
  return std::find_first_of(atStart.begin(), atStart.end(), atEnd.begin(), atEnd.end()) !=
    atStart.end();
}

// The other patches that share a junction with a patch.
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

std::vector<std::int32_t> lms3dBorderJunctions::GetHole(std::int32_t first) const
{
  const GridIndex lowerLeft = this->Junctions[first].LowerLeft;
  const Cell cell = this->Gates.GetCell(lowerLeft);
  std::vector<std::int32_t> hole;
  if (!this->Gates.IsContinuous(cell))
  {
    return hole;
  }
  for (int corner = 3; corner >= 0; --corner)
  {
    if (this->Gates.HasCellGate(cell, corner, Gates::Offset))
    {
      // The junction of the corner before this offset, clockwise.
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
