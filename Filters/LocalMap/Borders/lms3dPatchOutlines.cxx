// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dPatchOutlines.h"

#include "LocalMap/Borders/lms3dOffsetStrips.h"

#include <tbb/parallel_for.h>

namespace
{
using Gates = lms3dBorderGates;
} // namespace

lms3dPatchOutlines::lms3dPatchOutlines(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates)
  : Patches(patches)
  , Gates(gates)
  , BorderRanges(sphere, patches, gates)
  , Chains(gates)
  , Junctions(sphere, patches, gates, this->Chains, this->BorderRanges)
  , Paths(sphere, gates, this->BorderRanges, this->Chains, this->Junctions)
  , Bends(this->Chains.GetChains().size())
{
  for (int level = 0; level <= lms3dBorderJunctions::MaximumFallback; ++level)
  {
    this->Junctions.Locate(this->Vertices);
    this->StraightenChains();
    if (this->MakeStrips())
    {
      break;
    }
  }
  this->MakeLoops();
}

// After the first attempt, only the chains near flipped strips change.
void lms3dPatchOutlines::StraightenChains()
{
  const std::vector<Chain>& chains = this->Chains.GetChains();
  const bool isFirst = this->Lines.empty();
  tbb::parallel_for(std::size_t(0), chains.size(),
    [&](std::size_t i)
    {
      if (isFirst || this->Junctions.HasFallback(chains[i], lms3dBorderJunctions::JunctionsStay))
      {
        this->Bends[i] = this->Paths.Straighten(i, this->Vertices);
      }
    });
  this->NumberBends();
}

void lms3dPatchOutlines::NumberBends()
{
  this->Lines.assign(this->Bends.size(), {});
  for (std::size_t i = 0; i < this->Bends.size(); ++i)
  {
    Line& line = this->Lines[i];
    const bool isOffset = this->Chains.GetKind(i) == Gates::Offset;
    line.Own.reserve(this->Bends[i].size());
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

// Appends the side of a chain that begins with an edge. `next` receives the edge that begins the
// next side.
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

// Returns false if a strip is flipped.
bool lms3dPatchOutlines::MakeStrips()
{
  lms3dOffsetStrips strips(this->Vertices);
  this->PatchesAtFlippedStrips.clear();
  this->ReturnsAtFlippedStrips.clear();
  const std::vector<Chain>& chains = this->Chains.GetChains();
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (this->Chains.GetKind(i) == Gates::Offset &&
      !strips.AddStrip(this->GetWholeLine(i, 0), this->GetWholeLine(i, 1)))
    {
      this->AddFlippedStrip(chains[i]);
      this->Junctions.RaiseFallback(chains[i]);
    }
  }
  for (std::int32_t i = 0; i < this->Junctions.GetNumberOfJunctions(); ++i)
  {
    if (this->Junctions.IsFirstOfCell(i))
    {
      strips.FillHole(this->Junctions.GetHole(i));
    }
  }
  this->StripTriangles = strips.GetTriangles();
  return this->PatchesAtFlippedStrips.empty();
}

void lms3dPatchOutlines::AddFlippedStrip(const Chain& chain)
{
  for (int edge : { chain.Edges.front(), chain.Edges.back() })
  {
    this->ReturnsAtFlippedStrips.push_back(this->Gates.GetOwner(edge));
    this->ReturnsAtFlippedStrips.push_back(this->Gates.GetOwner(Gates::GetTwin(edge)));
  }
  const int edge = chain.Edges.front();
  this->PatchesAtFlippedStrips.push_back(this->Gates.GetPatch(edge));
  this->PatchesAtFlippedStrips.push_back(this->Gates.GetPatch(Gates::GetTwin(edge)));
}

// One side of a chain with the junctions at its ends or, if it is closed, its first vertex again.
std::vector<std::int32_t> lms3dPatchOutlines::GetWholeLine(std::size_t chain, int side) const
{
  const Chain& edges = this->Chains.GetChains()[chain];
  const std::vector<std::int32_t>& bends =
    side == 0 ? this->Lines[chain].Own : this->Lines[chain].Other;
  std::vector<std::int32_t> line;
  line.reserve(bends.size() + 2);
  if (!edges.IsClosed)
  {
    line.push_back(this->Junctions.GetStart(chain, side));
  }
  line.insert(line.end(), bends.begin(), bends.end());
  line.push_back(edges.IsClosed ? bends.front() : this->Junctions.GetEnd(chain, side));
  return line;
}
