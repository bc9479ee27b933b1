// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderPaths.h"

#include <algorithm>
#include <cmath>

namespace
{
using Gates = lms3dBorderGates;

// Half the width of a strip, as a share of a gate. It is less than half of the margin at beams.
constexpr double HalfStrip = 0.04;
// How far a border may reach into a gate if it must not meet the border beyond a depth step.
constexpr double MaximumAtSlit = 0.42;
// How far a border may reach into a gate in any case. A part of the gate without width would bend
// the border in each gate.
constexpr double MinimumExtension = 0.05;
// A depth step of at least this many tolerances cannot be bridged, however much both surfaces tilt.
constexpr double SafeStep = 6.0;
} // namespace

std::vector<lms3dMapVertex> lms3dBorderPaths::Straighten(
  std::size_t chain, const std::vector<lms3dMapVertex>& vertices) const
{
  const Chain& edges = this->Chains.GetChains()[chain];
  const std::vector<Path::Vertex> path =
    this->FindBends(chain, this->GetPathGates(edges), vertices);
  std::vector<lms3dMapVertex> bends;
  bends.reserve((this->Chains.GetKind(chain) == Gates::Offset ? 2 : 1) * path.size());
  for (const Path::Vertex& bend : path)
  {
    this->AppendVertices(edges.Edges[bend.Gate], bend.At, bends);
  }
  return bends;
}

std::vector<lms3dMinimumLinkPath::Gate> lms3dBorderPaths::GetPathGates(const Chain& chain) const
{
  std::vector<Path::Gate> gates;
  gates.reserve(chain.Edges.size());
  for (int edge : chain.Edges)
  {
    const Gates::Gate& gate = this->Gates.GetGate(edge);
    const bool isTurned = edge % 2 == 1;
    gates.push_back({ this->Sphere.GetDirection(gate.Ends[isTurned ? 1 : 0]),
      this->BorderRanges.GetDirectionBeyond(edge), isTurned ? 1.0 - gate.High : gate.Low,
      isTurned ? 1.0 - gate.Low : gate.High, isTurned ? 1.0 - gate.Best : gate.Best });
    if (gate.Kind == Gates::DepthStep)
    {
      this->LimitExtension(edge, gates.back());
    }
  }
  return gates;
}

// At a depth step, a surface extends no farther than its returns support. It also ends before the
// middle of the gate if it could meet the surface beyond: both may tilt towards each other or
// belong to one patch.
void lms3dBorderPaths::LimitExtension(int edge, Path::Gate& gate) const
{
  const double own = this->Sphere.GetRange(this->Gates.GetOwner(edge));
  const double other = this->Sphere.GetRange(this->Gates.GetOwner(Gates::GetTwin(edge)));
  if (other > 0.0 && std::abs(own - other) < SafeStep * this->Gates.GetTolerance())
  {
    gate.High = std::max(gate.Low, std::min(gate.High, MaximumAtSlit));
  }
  gate.High = std::max(
    std::max(gate.Low, MinimumExtension), this->BorderRanges.GetExtension(edge, gate.High));
  gate.Best = std::min(gate.Best, gate.High);
}

std::vector<lms3dMinimumLinkPath::Vertex> lms3dBorderPaths::FindBends(std::size_t number,
  const std::vector<Path::Gate>& gates, const std::vector<lms3dMapVertex>& vertices) const
{
  const Chain& chain = this->Chains.GetChains()[number];
  const Path path(gates);
  if (!this->Junctions.HasFallback(chain, lms3dBorderJunctions::PathsBendInEachGate))
  {
    return chain.IsClosed ? path.StraightenClosed() : this->FindOpenBends(number, path, vertices);
  }
  std::vector<Path::Vertex> bends;
  bends.reserve(gates.size());
  for (const Path::Gate& gate : gates)
  {
    bends.push_back({ static_cast<int>(bends.size()), gate.Best });
  }
  return bends;
}

std::vector<lms3dMinimumLinkPath::Vertex> lms3dBorderPaths::FindOpenBends(
  std::size_t number, const Path& path, const std::vector<lms3dMapVertex>& vertices) const
{
  // Along an offset, the path runs in the middle between the two borders.
  const int side = this->Chains.GetKind(number) == Gates::Offset ? 1 : 0;
  const auto getMiddle = [&](std::int32_t a, std::int32_t b)
  { return lms3dAdd(vertices[a].Direction, vertices[b].Direction); };
  const lms3dVector from =
    getMiddle(this->Junctions.GetStart(number, 0), this->Junctions.GetStart(number, side));
  const lms3dVector to =
    getMiddle(this->Junctions.GetEnd(number, 0), this->Junctions.GetEnd(number, side));
  // The two sides of a slit part in its first gate, each at the range of its own returns.
  std::vector<Path::Vertex> bends = path.Straighten(
    from, to, this->Junctions.IsEndOfSlit(number, 0), this->Junctions.IsEndOfSlit(number, 1));
  if (bends.empty() && this->Junctions.NeedsBendAtSlit(number))
  {
    bends.push_back(path.GetMiddle(from, to));
  }
  return bends;
}

void lms3dBorderPaths::AppendVertices(int edge, double at, std::vector<lms3dMapVertex>& out) const
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
