// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dPatchOutlines.h"

#include "LocalMap/Borders/lms3dOffsetStrips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace
{
using Gates = lms3dBorderGates;

// Half the width of a band, as a share of a gate: less than half of what borders keep off beams.
constexpr double HalfStrip = 0.04;
// How near to the middle of a gate borders may come that must not meet those beyond a cut, as a
// share of the gate.
constexpr double HalfSlit = 0.42;
// A depth step of so many bounds cannot be bridged, however far the surfaces on both sides lean.
constexpr double SafeStep = 6.0;
// The grades of care for a band that turns over: its junctions stay in the middle of their cells, then
// its lines pass every gate.
constexpr int MaximumFallback = 2;
} // namespace

lms3dPatchOutlines::lms3dPatchOutlines(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates)
  : Sphere(sphere)
  , Patches(patches)
  , Gates(gates)
  , BorderRanges(sphere, patches, gates)
  , Chains(gates)
  , Junctions(sphere, patches, gates, this->Chains, this->BorderRanges)
  , Lines(this->Chains.GetChains().size())
{
  for (int level = 0; level <= MaximumFallback; ++level)
  {
    this->Vertices = this->Junctions.Locate();
    this->StraightenChains();
    if (!this->MakeStrips())
    {
      break;
    }
  }
  this->MakeLoops();
}

bool lms3dPatchOutlines::IsOffset(const Chain& chain) const
{
  return this->Gates.GetGate(chain.Edges.front()).Kind == Gates::Offset;
}

// Again only those that need more care now.
void lms3dPatchOutlines::StraightenChains()
{
  const std::vector<Chain>& chains = this->Chains.GetChains();
  const bool isFirst = this->Bends.empty();
  this->Bends.resize(chains.size());
  tbb::parallel_for(std::size_t(0), chains.size(),
    [&](std::size_t i)
    {
      if (isFirst || this->HasFallback(chains[i]))
      {
        this->Bends[i] = this->Straighten(i);
      }
    });
  this->NumberBends();
}

bool lms3dPatchOutlines::HasFallback(const Chain& chain) const
{
  return this->Junctions.HasFallback(this->Junctions.GetEndCell(chain, 0), 1) ||
    this->Junctions.HasFallback(this->Junctions.GetEndCell(chain, 1), 1);
}

void lms3dPatchOutlines::NumberBends()
{
  for (std::size_t i = 0; i < this->Bends.size(); ++i)
  {
    Line& line = this->Lines[i];
    line = {};
    const bool isOffset = this->IsOffset(this->Chains.GetChains()[i]);
    for (std::size_t j = 0; j < this->Bends[i].size(); ++j)
    {
      const std::int32_t number = static_cast<std::int32_t>(this->Vertices.size());
      this->Vertices.push_back(this->Bends[i][j]);
      (isOffset && j % 2 == 1 ? line.Other : line.Own).push_back(number);
    }
    if (!isOffset)
    {
      line.Other = line.Own;
    }
  }
}

std::vector<lms3dMinimumLinkPath::Gate> lms3dPatchOutlines::GetLineGates(const Chain& chain) const
{
  std::vector<lms3dMinimumLinkPath::Gate> gates;
  gates.reserve(chain.Edges.size());
  for (int edge : chain.Edges)
  {
    const Gates::Gate& gate = this->Gates.GetGate(edge);
    const bool isTurned = edge % 2 == 1;
    gates.push_back({ this->Sphere.GetDirection(gate.Ends[isTurned ? 1 : 0]),
      this->Sphere.GetDirection(gate.Ends[isTurned ? 0 : 1]), isTurned ? 1.0 - gate.High : gate.Low,
      isTurned ? 1.0 - gate.Low : gate.High, isTurned ? 1.0 - gate.Best : gate.Best });
    if (gate.Kind == Gates::DepthStep)
    {
      this->LimitExtension(edge, gates.back());
    }
  }
  return gates;
}

// At a cut a surface goes no farther than its returns support, and not beyond the middle where it
// might meet the surface on the other side: both may lean towards each other, or be one patch.
void lms3dPatchOutlines::LimitExtension(int edge, lms3dMinimumLinkPath::Gate& gate) const
{
  const double own = this->Sphere.GetRange(this->Gates.GetOwner(edge));
  const double other = this->Sphere.GetRange(this->Gates.GetOwner(Gates::GetTwin(edge)));
  if (other > 0.0 && std::abs(own - other) < SafeStep * this->Gates.GetTolerance())
  {
    gate.High = std::max(gate.Low, std::min(gate.High, HalfSlit));
  }
  gate.High = std::max(gate.Low, this->BorderRanges.GetExtension(edge, gate.High));
  gate.Best = std::min(gate.Best, gate.High);
}

std::vector<lms3dMapVertex> lms3dPatchOutlines::Straighten(std::size_t number) const
{
  const Chain& chain = this->Chains.GetChains()[number];
  std::vector<lms3dMapVertex> vertices;
  for (const lms3dMinimumLinkPath::Vertex& bend :
    this->FindBends(number, this->GetLineGates(chain)))
  {
    this->AppendVertices(chain.Edges[bend.Gate], bend.At, vertices);
  }
  return vertices;
}

std::vector<lms3dMinimumLinkPath::Vertex> lms3dPatchOutlines::FindBends(
  std::size_t number, const std::vector<lms3dMinimumLinkPath::Gate>& gates) const
{
  const Chain& chain = this->Chains.GetChains()[number];
  const lms3dMinimumLinkPath line(gates);
  if (this->Junctions.HasFallback(this->Junctions.GetEndCell(chain, 0), MaximumFallback) ||
    this->Junctions.HasFallback(this->Junctions.GetEndCell(chain, 1), MaximumFallback))
  {
    std::vector<lms3dMinimumLinkPath::Vertex> bends;
    bends.reserve(gates.size());
    for (const lms3dMinimumLinkPath::Gate& gate : gates)
    {
      bends.push_back({ static_cast<int>(bends.size()), gate.Best });
    }
    return bends;
  }
  if (chain.IsClosed)
  {
    return line.StraightenClosed();
  }
  // Between the two lines of a step; they are one elsewhere.
  const int side = this->IsOffset(chain) ? 1 : 0;
  const lms3dVector from =
    this->GetMiddle(this->Junctions.GetStart(number, 0), this->Junctions.GetStart(number, side));
  const lms3dVector to =
    this->GetMiddle(this->Junctions.GetEnd(number, 0), this->Junctions.GetEnd(number, side));
  // The lips of a slit part in its first gate, each at the range of its own side.
  std::vector<lms3dMinimumLinkPath::Vertex> bends = line.Straighten(
    from, to, this->Junctions.IsEndOfSlit(number, 0), this->Junctions.IsEndOfSlit(number, 1));
  if (bends.empty() && this->Junctions.NeedsBendAtSlit(number))
  {
    bends.push_back(line.GetMiddle(from, to));
  }
  return bends;
}

lms3dVector lms3dPatchOutlines::GetMiddle(std::int32_t a, std::int32_t b) const
{
  return lms3dAdd(this->Vertices[a].Direction, this->Vertices[b].Direction);
}

// One for both sides, or along a step two: of the own side and of the other.
void lms3dPatchOutlines::AppendVertices(int edge, double at, std::vector<lms3dMapVertex>& out) const
{
  if (this->Gates.GetGate(edge).Kind == Gates::Offset)
  {
    out.push_back(this->BorderRanges.GetVertexInGate(edge, at - HalfStrip));
    out.push_back(this->BorderRanges.GetVertexInGate(Gates::GetTwin(edge), 1.0 - (at + HalfStrip)));
  }
  else
  {
    out.push_back(this->BorderRanges.GetVertexInGate(edge, at));
  }
}

void lms3dPatchOutlines::MakeLoops()
{
  this->Outlines.resize(this->Patches.Patches.size());
  std::vector<bool> visited(this->Gates.GetNumberOfEdges(), false);
  for (int first = 0; first < this->Gates.GetNumberOfEdges(); ++first)
  {
    if (this->Chains.GetChainOf(first) < 0 || visited[first])
    {
      continue;
    }
    Outline& outline = this->Outlines[this->Gates.GetPatch(first)];
    int edge = first;
    do
    {
      visited[edge] = true;
      this->AppendSide(edge, outline, edge);
    } while (edge != first);
    outline.LoopEnds.push_back(static_cast<std::int32_t>(outline.Vertices.size()));
  }
}

// Of a chain, the side that an edge begins, and the edge that begins the next one.
void lms3dPatchOutlines::AppendSide(int edge, Outline& outline, int& next) const
{
  const std::int32_t side = this->Chains.GetChainOf(edge);
  const Chain& chain = this->Chains.GetChains()[side / 2];
  const Line& line = this->Lines[side / 2];
  std::vector<std::int32_t>& vertices = outline.Vertices;
  if (!chain.IsClosed)
  {
    vertices.push_back(
      side % 2 == 0 ? this->Junctions.GetStart(side / 2, 0) : this->Junctions.GetEnd(side / 2, 1));
  }
  if (side % 2 == 0)
  {
    vertices.insert(vertices.end(), line.Own.begin(), line.Own.end());
    next = this->Gates.GetNext(chain.Edges.back());
  }
  else
  {
    vertices.insert(vertices.end(), line.Other.rbegin(), line.Other.rend());
    next = this->Gates.GetNext(Gates::GetTwin(chain.Edges.front()));
  }
}

// Returns whether another attempt is due.
bool lms3dPatchOutlines::MakeStrips()
{
  lms3dOffsetStrips strips(this->Vertices);
  this->PatchesAtFlippedStrips.clear();
  const std::vector<Chain>& chains = this->Chains.GetChains();
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (this->IsOffset(chains[i]) &&
      !strips.AddStrip(this->GetWholeLine(i, 0), this->GetWholeLine(i, 1)))
    {
      const int edge = chains[i].Edges.front();
      this->PatchesAtFlippedStrips.push_back(this->Gates.GetPatch(edge));
      this->PatchesAtFlippedStrips.push_back(this->Gates.GetPatch(Gates::GetTwin(edge)));
      this->Junctions.RaiseFallback(this->Junctions.GetEndCell(chains[i], 0));
      this->Junctions.RaiseFallback(this->Junctions.GetEndCell(chains[i], 1));
    }
  }
  for (std::int32_t i = 0; i < this->Junctions.GetNumberOfJunctions(); ++i)
  {
    if (this->Junctions.IsFirstOfCell(i))
    {
      strips.FillHole(this->Junctions.GetHole(i));
    }
  }
  this->Strips = strips.GetTriangles();
  return !this->PatchesAtFlippedStrips.empty();
}

// With the junctions at its ends, or its first vertex again where it is closed.
std::vector<std::int32_t> lms3dPatchOutlines::GetWholeLine(std::size_t chain, int side) const
{
  const Chain& edges = this->Chains.GetChains()[chain];
  std::vector<std::int32_t> line = side == 0 ? this->Lines[chain].Own : this->Lines[chain].Other;
  if (edges.IsClosed)
  {
    line.push_back(line.front());
  }
  else
  {
    line.insert(line.begin(), this->Junctions.GetStart(chain, side));
    line.push_back(this->Junctions.GetEnd(chain, side));
  }
  return line;
}
