// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dTriangleOfDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
// The number of vertices that a thread prepares at least, and tries to move.
constexpr std::size_t VerticesOfTask = 16;
constexpr std::size_t MovesOfTask = 3;
} // namespace

lms3dVertexRemover::lms3dVertexRemover(const lms3dVertexMoves& moves, lms3dVertexStars& stars)
  : Moves(moves)
  , Stars(stars)
  , Candidates(stars.GetNumberOfVertices())
  , Changed(stars.GetNumberOfVertices())
  , Queue(stars)
{
  std::iota(this->Changed.begin(), this->Changed.end(), 0);
}

bool lms3dVertexRemover::Run()
{
  bool isChanged = false;
  while (true)
  {
    lms3dForEachInTasks(this->Changed.size(), VerticesOfTask,
      [&](std::size_t i) { this->Prepare(this->Changed[i]); });
    this->UpdateQueue();
    const std::vector<std::int32_t> selected = this->Queue.TakeIndependent();
    if (selected.empty())
    {
      return isChanged;
    }
    lms3dForEachInTasks(
      selected.size(), MovesOfTask, [&](std::size_t i) { this->TryToMove(selected[i]); });
    this->CollectChanged(selected);
    isChanged |= !this->Changed.empty();
  }
}

// Decides whether a vertex may move, after its star or the star of a neighbour has changed.
void lms3dVertexRemover::Prepare(std::int32_t vertex)
{
  if (this->Candidates[vertex].IsStarChanged)
  {
    this->LookAtStar(vertex);
  }
}

void lms3dVertexRemover::LookAtStar(std::int32_t vertex)
{
  Candidate& candidate = this->Candidates[vertex];
  const lms3dVertexStars::Border border = candidate.Border;
  const lms3dVertexStars::Border line = candidate.Line;
  candidate.IsStarChanged = false;
  candidate.HasFailed = false;
  if (candidate.IsInside)
  {
    candidate.Cost = this->GetCostInside(vertex);
  }
  else if (!this->FindLine(vertex, candidate))
  {
    candidate.IsFixed = true;
    candidate.Line = {};
  }
  else if (!candidate.Line.IsOpen())
  {
    candidate.IsInside = true;
    candidate.IsFixed = false;
    candidate.Cost = this->GetCostInside(vertex);
  }
  // The same line has the same cost, and may be left as before.
  else if (!(candidate.Border == border && candidate.Line == line))
  {
    candidate.IsFixed = !this->MayLeaveLine(vertex, candidate);
    candidate.Cost = candidate.IsFixed ? 0.0 : this->GetCostOnLine(vertex, candidate.Line);
  }
}

// Returns false if the vertex cannot move, since its triangles do not follow each other around it.
bool lms3dVertexRemover::FindLine(std::int32_t vertex, Candidate& candidate) const
{
  if (!this->Stars.FindBorder(vertex, candidate.Border))
  {
    return false;
  }
  candidate.Line = candidate.Border;
  return candidate.Border.IsOpen() || !this->Stars.HasStrip(vertex) ||
    this->Stars.FindBorderOfPatches(vertex, candidate.Line);
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
  const double turn = lms3dGetTurn(last, this->GetDirection(vertex), next);
  const double cost = turn * turn / lms3dGetSquareOfChord(last, next);
  return std::isfinite(cost) ? cost : 0.0;
}

double lms3dVertexRemover::GetCostInside(std::int32_t vertex) const
{
  double cost = std::numeric_limits<double>::infinity();
  this->Stars.ForEachTriangle(vertex,
    [&](std::int32_t, std::int32_t next, std::int32_t)
    {
      cost =
        std::min(cost, lms3dGetSquareOfChord(this->GetDirection(next), this->GetDirection(vertex)));
      return true;
    });
  return cost;
}

void lms3dVertexRemover::UpdateQueue()
{
  std::vector<lms3dVertexQueue::Entry> added;
  for (std::int32_t vertex : this->Changed)
  {
    if (!this->Candidates[vertex].IsFixed)
    {
      added.push_back({ this->Candidates[vertex].Cost, vertex });
    }
  }
  this->Queue.Update(this->Changed, std::move(added));
}

// Reads and changes only the star of the vertex, and what its neighbours have of it. Other threads
// test and move vertices meanwhile. A vertex looks at the triangles around its target, too, but
// none of them has another vertex of the round: the target would lie in both stars.
void lms3dVertexRemover::Move(std::int32_t vertex, std::int32_t to)
{
  this->Candidates[vertex].To = to;
  this->Stars.ForEachTriangle(vertex,
    [this](std::int32_t, std::int32_t next, std::int32_t last)
    {
      this->Candidates[next].IsStarChanged = true;
      this->Candidates[last].IsStarChanged = true;
      return true;
    });
  this->Stars.Merge(vertex, to);
}

// Those around the vertices that have moved. The others are not tried again until their stars
// change.
void lms3dVertexRemover::CollectChanged(const std::vector<std::int32_t>& vertices)
{
  this->Changed.clear();
  for (std::int32_t vertex : vertices)
  {
    const std::int32_t to = this->Candidates[vertex].To;
    if (to != None)
    {
      this->Changed.push_back(to);
      this->Stars.ForEachTriangle(to,
        [this](std::int32_t, std::int32_t next, std::int32_t last)
        {
          this->Changed.push_back(next);
          this->Changed.push_back(last);
          return true;
        });
    }
  }
  std::sort(this->Changed.begin(), this->Changed.end());
  this->Changed.erase(std::unique(this->Changed.begin(), this->Changed.end()), this->Changed.end());
}
