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
// The smallest height of a triangle as the sensor sees it, as a share of its longest edge.
// Triangles may be as flat as those that they replace.
constexpr double MinimumHeight = 0.01;
// The number of neighbours that a vertex tries to move to.
constexpr std::size_t MaximumTargets = 6;
// The number of vertices that a thread prepares at least, and tries to move.
constexpr std::size_t VerticesOfTask = 32;
constexpr std::size_t MovesOfTask = 8;
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
    isChanged |= this->Move(selected);
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
  if (!this->FindLine(vertex, candidate))
  {
    candidate.IsFixed = true;
    candidate.Line = {};
  }
  else if (!candidate.Line.IsOpen())
  {
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

void lms3dVertexRemover::TryToMove(std::int32_t vertex)
{
  Candidate& candidate = this->Candidates[vertex];
  if (candidate.HasFailed)
  {
    return;
  }
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
  candidate.HasFailed = true;
}

// The neighbours to which a vertex may move, the nearest first.
std::vector<lms3dVertexRemover::Target> lms3dVertexRemover::FindTargets(std::int32_t vertex) const
{
  const Candidate& candidate = this->Candidates[vertex];
  std::vector<Target> targets;
  const auto add = [&](std::int32_t target)
  {
    targets.push_back(
      { lms3dGetSquareOfChord(this->GetDirection(vertex), this->GetDirection(target)), target });
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
        lms3dGetHeightShare(
          this->GetDirection(vertex), this->GetDirection(next), this->GetDirection(last)));
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
      return lms3dGetHeightShare(this->GetDirection(to), this->GetDirection(next),
               this->GetDirection(last)) >= minimumHeight;
    });
}

// Whether the neighbours that both vertices have in common belong to the triangles between them.
bool lms3dVertexRemover::AreLinked(std::int32_t from, std::int32_t to) const
{
  const Candidate& candidate = this->Candidates[from];
  const lms3dStarSides besideTo = this->Stars.GetSides(to);
  int allowed = candidate.Border.IsOpen() ? 1 : 2;
  const auto count = [&](std::int32_t neighbor)
  {
    allowed -= neighbor != to && besideTo.Has(neighbor) ? 1 : 0;
    return allowed >= 0;
  };
  return (!candidate.Border.IsOpen() || count(candidate.Border.Last)) &&
    this->Stars.ForEachTriangle(
      from, [&](std::int32_t, std::int32_t next, std::int32_t) { return count(next); });
}

// Moves the vertices that can. The others are not tried again until their stars change. Returns
// false if none moves.
bool lms3dVertexRemover::Move(const std::vector<std::int32_t>& vertices)
{
  this->Changed.clear();
  for (std::int32_t vertex : vertices)
  {
    if (this->Candidates[vertex].To != None)
    {
      this->MoveOne(vertex);
    }
  }
  std::sort(this->Changed.begin(), this->Changed.end());
  this->Changed.erase(std::unique(this->Changed.begin(), this->Changed.end()), this->Changed.end());
  return !this->Changed.empty();
}

void lms3dVertexRemover::MoveOne(std::int32_t vertex)
{
  const std::int32_t to = this->Candidates[vertex].To;
  this->Stars.ForEachTriangle(vertex,
    [this](std::int32_t, std::int32_t next, std::int32_t last)
    {
      this->Candidates[next].IsStarChanged = true;
      this->Candidates[last].IsStarChanged = true;
      return true;
    });
  this->Stars.Merge(vertex, to);
  this->Changed.push_back(to);
  this->Stars.ForEachTriangle(to,
    [this](std::int32_t, std::int32_t next, std::int32_t last)
    {
      this->Changed.push_back(next);
      this->Changed.push_back(last);
      return true;
    });
}
