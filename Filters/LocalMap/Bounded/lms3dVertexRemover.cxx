// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace
{
// The smallest height of a triangle as the sensor sees it, as a share of its longest edge. Triangles may be as flat as
// those that they replace.
constexpr double MinimumHeight = 0.01;
// The number of neighbours that a vertex tries to move to.
constexpr std::size_t MaximumTargets = 6;

double GetSquare(const lms3dVector& a, const lms3dVector& b)
{
  const lms3dVector edge = lms3dSubtract(a, b);
  return lms3dDot(edge, edge);
}

// Positive if the sensor sees the corners counter-clockwise.
double GetTurn(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return lms3dDot(lms3dCross(c, b), a);
}

// The height of a triangle of directions, as a share of its longest edge.
double GetHeight(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return GetTurn(a, b, c) / std::max({ GetSquare(a, b), GetSquare(b, c), GetSquare(c, a) });
}
} // namespace

lms3dVertexRemover::lms3dVertexRemover(const lms3dVertexMoves& moves, lms3dVertexStars& stars)
  : Moves(moves)
  , Stars(stars)
  , Candidates(stars.GetNumberOfVertices())
  , Changed(stars.GetNumberOfVertices())
{
  std::iota(this->Changed.begin(), this->Changed.end(), 0);
}

bool lms3dVertexRemover::Run()
{
  bool isChanged = false;
  while (true)
  {
    tbb::parallel_for(std::size_t(0), this->Changed.size(),
      [&](std::size_t i) { this->Prepare(this->Changed[i]); });
    const std::vector<std::int32_t> selected = this->SelectIndependent();
    if (selected.empty())
    {
      return isChanged;
    }
    tbb::parallel_for(
      std::size_t(0), selected.size(), [&](std::size_t i) { this->TryToMove(selected[i]); });
    isChanged |= this->Move(selected);
  }
}

// Decides whether a vertex may move, after its star has changed.
void lms3dVertexRemover::Prepare(std::int32_t vertex)
{
  Candidate candidate;
  const lms3dVertexStars::Border& line = candidate.Line;
  candidate.IsSettled =
    !this->FindLine(vertex, candidate) || (line.IsOpen() && !this->MayLeaveLine(vertex, candidate));
  if (!candidate.IsSettled)
  {
    candidate.Cost =
      line.IsOpen() ? this->GetCostOnLine(vertex, line) : this->GetCostInside(vertex);
  }
  this->Candidates[vertex] = candidate;
}

// Returns false if the vertex cannot move, since its triangles do not follow each other around it.
bool lms3dVertexRemover::FindLine(std::int32_t vertex, Candidate& candidate) const
{
  if (!this->Stars.FindBorder(vertex, candidate.Border))
  {
    return false;
  }
  candidate.Line = candidate.Border;
  return candidate.Border.IsOpen() || this->Stars.FindBorderOfPatches(vertex, candidate.Line);
}

bool lms3dVertexRemover::MayLeaveLine(std::int32_t vertex, const Candidate& candidate) const
{
  const lms3dVertexStars::Border& line = candidate.Line;
  return candidate.Border.IsOpen()
    ? this->Moves.MayLeaveBorder(this->Stars, line.Last, vertex, line.Next)
    : this->Moves.MayLeaveOffset(this->Stars, line.Last, vertex, line.Next);
}

double lms3dVertexRemover::GetCostOnLine(
  std::int32_t vertex, const lms3dVertexStars::Border& line) const
{
  const lms3dVector& last = this->GetDirection(line.Last);
  const lms3dVector& next = this->GetDirection(line.Next);
  const double turn = GetTurn(last, this->GetDirection(vertex), next);
  const double cost = turn * turn / GetSquare(last, next);
  return std::isfinite(cost) ? cost : 0.0;
}

double lms3dVertexRemover::GetCostInside(std::int32_t vertex) const
{
  double cost = std::numeric_limits<double>::infinity();
  this->Stars.ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t)
    {
      cost = std::min(cost, GetSquare(this->GetDirection(next), this->GetDirection(vertex)));
      return true;
    });
  return cost;
}

// Selects vertices, the cheapest first, whose stars have no vertex in common.
std::vector<std::int32_t> lms3dVertexRemover::SelectIndependent() const
{
  std::vector<std::int32_t> order;
  for (std::int32_t vertex = 0; vertex < this->Stars.GetNumberOfVertices(); ++vertex)
  {
    if (!this->Candidates[vertex].IsSettled)
    {
      order.push_back(vertex);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](std::int32_t a, std::int32_t b)
    { return std::tie(this->Candidates[a].Cost, a) < std::tie(this->Candidates[b].Cost, b); });
  std::vector<bool> isUsed(this->Stars.GetNumberOfVertices(), false);
  std::vector<std::int32_t> selected;
  for (std::int32_t vertex : order)
  {
    if (this->Stars.ForEachTriangle(vertex,
          [&](std::int32_t, std::int32_t next, std::int32_t last)
          { return !isUsed[next] && !isUsed[last]; }) &&
      !isUsed[vertex])
    {
      isUsed[vertex] = true;
      this->Stars.ForEachTriangle(vertex,
        [&](std::int32_t, std::int32_t next, std::int32_t last)
        {
          isUsed[next] = true;
          isUsed[last] = true;
          return true;
        });
      selected.push_back(vertex);
    }
  }
  return selected;
}

void lms3dVertexRemover::TryToMove(std::int32_t vertex)
{
  Candidate& candidate = this->Candidates[vertex];
  const double height =
    std::clamp(this->GetSmallestHeight(vertex), std::numeric_limits<double>::min(), MinimumHeight);
  for (const Target& target : this->FindTargets(vertex))
  {
    if (this->CanMove(vertex, target.Vertex, height))
    {
      candidate.To = target.Vertex;
      return;
    }
  }
}

// The neighbours to which a vertex may move, the nearest first.
std::vector<lms3dVertexRemover::Target> lms3dVertexRemover::FindTargets(std::int32_t vertex) const
{
  const Candidate& candidate = this->Candidates[vertex];
  std::vector<Target> targets;
  const auto add = [&](std::int32_t target)
  {
    targets.push_back(
      { GetSquare(this->GetDirection(vertex), this->GetDirection(target)), target });
  };
  if (candidate.Line.IsOpen())
  {
    add(candidate.Line.Last);
    add(candidate.Line.Next);
  }
  else
  {
    this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t)
      {
        add(next);
        return true;
      });
  }
  std::sort(targets.begin(), targets.end());
  targets.resize(std::min(targets.size(), MaximumTargets));
  return targets;
}

double lms3dVertexRemover::GetSmallestHeight(std::int32_t vertex) const
{
  double height = std::numeric_limits<double>::infinity();
  this->Stars.ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t last)
    {
      height = std::min(height,
        GetHeight(this->GetDirection(vertex), this->GetDirection(next), this->GetDirection(last)));
      return true;
    });
  return height;
}

bool lms3dVertexRemover::CanMove(std::int32_t from, std::int32_t to, double minimumHeight) const
{
  return this->HasSoundShape(from, to, minimumHeight) && this->AreLinked(from, to) &&
    this->Moves.KeepsBound(this->Stars, from, to);
}

bool lms3dVertexRemover::HasSoundShape(
  std::int32_t from, std::int32_t to, double minimumHeight) const
{
  return this->Stars.ForEachSide(from, to,
    [&](std::int32_t next, std::int32_t last)
    {
      return GetHeight(this->GetDirection(to), this->GetDirection(next),
               this->GetDirection(last)) >= minimumHeight;
    });
}

// Whether the neighbours that both vertices have in common belong to the triangles between them.
bool lms3dVertexRemover::AreLinked(std::int32_t from, std::int32_t to) const
{
  const Candidate& candidate = this->Candidates[from];
  int allowed = candidate.Border.IsOpen() ? 1 : 2;
  const auto count = [&](std::int32_t neighbor)
  {
    allowed -= neighbor != to && this->Stars.AreNeighbors(neighbor, to) ? 1 : 0;
    return allowed >= 0;
  };
  return (!candidate.Border.IsOpen() || count(candidate.Border.Last)) &&
    this->Stars.ForEachTriangle(
      from, [&](std::int32_t, std::int32_t next, std::int32_t) { return count(next); });
}

// Moves the vertices that can. The others are not tried again until their stars change. Returns false if none moves.
bool lms3dVertexRemover::Move(const std::vector<std::int32_t>& vertices)
{
  this->Changed.clear();
  for (std::int32_t vertex : vertices)
  {
    Candidate& candidate = this->Candidates[vertex];
    candidate.IsSettled = true;
    if (candidate.To != None)
    {
      this->Stars.Merge(vertex, candidate.To);
      const std::vector<std::int32_t> neighbors = this->Stars.GetNeighbors(candidate.To);
      this->Changed.insert(this->Changed.end(), neighbors.begin(), neighbors.end());
      this->Changed.push_back(candidate.To);
    }
  }
  std::sort(this->Changed.begin(), this->Changed.end());
  this->Changed.erase(std::unique(this->Changed.begin(), this->Changed.end()), this->Changed.end());
  return !this->Changed.empty();
}
