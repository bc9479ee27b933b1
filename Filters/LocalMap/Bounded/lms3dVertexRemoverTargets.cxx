// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dTriangleOfDirections.h"
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include <algorithm>
#include <limits>

namespace
{
// The smallest height of a triangle as the sensor sees it, as a share of its longest edge.
// Triangles may be as flat as those that they replace.
constexpr double MinimumHeight = 0.01;
} // namespace

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
      this->Move(vertex, target.Vertex);
      return;
    }
  }
  candidate.HasFailed = true;
}

// The neighbours to which a vertex may move, the nearest first.
lms3dVertexRemover::Targets lms3dVertexRemover::FindTargets(std::int32_t vertex) const
{
  const Candidate& candidate = this->Candidates[vertex];
  Targets targets;
  const auto add = [&](std::int32_t target)
  {
    targets.Add(
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
  return targets;
}

void lms3dVertexRemover::Targets::Add(const Target& target)
{
  std::size_t place = this->Size;
  for (; place > 0 && target < this->Nearest[place - 1]; --place)
  {
    this->Nearest[place] = this->Nearest[place - 1];
  }
  this->Nearest[place] = target;
  this->Size = std::min(this->Size + 1, MaximumTargets);
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
