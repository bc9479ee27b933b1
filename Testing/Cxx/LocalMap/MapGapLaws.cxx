// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;
using Place = ScanGrid::Place;

/// The default of MaximumGapSize in scans with Status.
constexpr std::size_t DefaultGapSize = 25;

/// The groups of beams without a return that the filter may close.
class ClosableGaps
{
public:
  explicit ClosableGaps(const MapCase& map);

  static constexpr int NoGroup = -1;

  /// The number of a beam's group, or NoGroup.
  int GetGroup(const Beam& beam) const { return this->Groups[this->GetIndex(beam)]; }

private:
  std::size_t GetIndex(const Beam& beam) const;
  /// Returns the group of a beam. Beams of one pole count once.
  std::vector<Beam> Collect(const Beam& beam, std::vector<bool>& isFound) const;
  bool IsClosable(const std::vector<Beam>& gap) const;
  bool IsAtEdge(const Beam& beam) const;
  bool IsFreeSpace(const Beam& beam) const;

  const ScanGrid& Grid;
  vtkDataArray* Status;
  std::size_t MaximumSize;
  std::vector<int> Groups;
};

std::array<Beam, 4> GetNeighbours(const Beam& beam)
{
  const auto [turn, number] = beam;
  return { { { turn - 1, number }, { turn + 1, number }, { turn, number - 1 },
    { turn, number + 1 } } };
}

ClosableGaps::ClosableGaps(const MapCase& map)
  : Grid(map.Grid)
  , Status(map.Scan->GetFieldData()->GetArray("Status"))
{
  const int size = map.Promise.MaximumGapSize;
  this->MaximumSize =
    size >= 0 ? static_cast<std::size_t>(size) : (this->Status ? DefaultGapSize : 0);
  const int turns = this->Grid.GetNumberOfTurns();
  const int numbers = this->Grid.GetNumberOfBeams();
  this->Groups.assign(static_cast<std::size_t>(turns) * numbers, NoGroup);
  std::vector<bool> isFound(this->Groups.size(), false);
  int count = 0;
  for (int turn = 0; turn < turns; ++turn)
  {
    for (int number = 0; number < numbers; ++number)
    {
      const std::vector<Beam> gap = this->Collect({ turn, number }, isFound);
      const int group = !map.IsPlain() && this->IsClosable(gap) ? count++ : NoGroup;
      for (const Beam& beam : gap)
      {
        this->Groups[this->GetIndex(beam)] = group;
      }
    }
  }
}

std::size_t ClosableGaps::GetIndex(const Beam& beam) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  // A gap can go around the circle more than once.
  const int turn = this->Grid.IsPole(beam.Number) ? 0 : (beam.Turn % turns + turns) % turns;
  return static_cast<std::size_t>(turn) * this->Grid.GetNumberOfBeams() + beam.Number;
}

std::vector<Beam> ClosableGaps::Collect(const Beam& beam, std::vector<bool>& isFound) const
{
  std::vector<Beam> gap;
  std::vector<Beam> waiting = { beam };
  while (!waiting.empty())
  {
    const Beam next = waiting.back();
    waiting.pop_back();
    if (!this->Grid.Contains(next) || this->Grid.GetReturn(next) != ScanGrid::NoReturn ||
      isFound[this->GetIndex(next)])
    {
      continue;
    }
    isFound[this->GetIndex(next)] = true;
    gap.push_back(next);
    for (int turn = 0; turn < this->Grid.GetNumberOfTurns() && this->Grid.IsPole(next.Number);
         ++turn)
    {
      waiting.push_back({ turn, next.Number + (next.Number == 0 ? 1 : -1) });
    }
    for (const Beam& neighbour : GetNeighbours(next))
    {
      waiting.push_back(neighbour);
    }
  }
  return gap;
}

bool ClosableGaps::IsClosable(const std::vector<Beam>& gap) const
{
  return gap.size() <= this->MaximumSize &&
    std::none_of(gap.begin(), gap.end(),
      [this](const Beam& beam) { return this->IsAtEdge(beam) || this->IsFreeSpace(beam); });
}

bool ClosableGaps::IsAtEdge(const Beam& beam) const
{
  const std::array<Beam, 4> neighbours = GetNeighbours(beam);
  return !this->Grid.IsPole(beam.Number) &&
    std::any_of(neighbours.begin(), neighbours.end(),
      [this](const Beam& neighbour) { return !this->Grid.Contains(neighbour); });
}

bool ClosableGaps::IsFreeSpace(const Beam& beam) const
{
  if (!this->Status)
  {
    return false;
  }
  const double status = this->Status->GetTuple1(static_cast<vtkIdType>(this->GetIndex(beam)));
  return status == vtkLMS3DScanFilter::NOTHING_MET || status == vtkLMS3DScanFilter::BEYOND_RANGE;
}

// Whether all rays close around a beam hit surface. Surface that ends at the beam, or has a corner
// there, does not count.
bool IsCovered(const MapCase& map, const TriangleTree& surface, const Beam& beam)
{
  constexpr double Offset = 1e-3;
  std::vector<TriangleTree::Hit> hits;
  for (const Place& aside : { Place{ -Offset, -Offset }, Place{ -Offset, Offset },
         Place{ Offset, -Offset }, Place{ Offset, Offset } })
  {
    surface.Cast(map.Grid.GetDirection({ beam.Turn + aside.Turn, beam.Number + aside.Number }),
      -BeamMargin, hits);
    if (hits.empty())
    {
      return false;
    }
  }
  return true;
}

// Judges a closed gap by what the beam meets in the scan without errors.
void JudgePassage(const MapCase& map, const MapCase& ideal, const TriangleTree& surface,
  const Beam& beam, MapVerdict& verdict)
{
  const vtkIdType number = ideal.Grid.GetReturn(beam);
  if (number == ScanGrid::NoReturn)
  {
    return;
  }
  const Vector& point = ideal.Grid.GetPoints()[number];
  const double range = GetLength(point);
  std::vector<TriangleTree::Hit> hits;
  surface.Cast(Normalize(point), BeamMargin, hits);
  for (const TriangleTree::Hit& hit : hits)
  {
    const double distance = GetDistance(point, surface.GetCorners(hit.Triangle));
    if (hit.Range < range &&
      distance > map.Promise.MaximumError + map.Promise.Noise + MapCase::GetRounding(range))
    {
      verdict.Add("passage",
        map.Grid.Describe(beam) + " meets the map at " + std::to_string(hit.Range) +
          " m and the scene at " + std::to_string(range) + " m",
        distance);
    }
  }
}
} // namespace

void JudgeGaps(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict)
{
  const ClosableGaps gaps(map);
  const std::unique_ptr<const MapCase> ideal = map.MakeIdeal();
  const std::set<int> named = GetFieldNumbers(map.Map, "ClosedBeamIds");
  std::set<int> closed;
  std::set<int> groups;
  for (int turn = 0; turn < map.Grid.GetNumberOfTurns(); ++turn)
  {
    for (int number = 0; number < map.Grid.GetNumberOfBeams(); ++number)
    {
      const Beam beam = { turn, number };
      if (map.Grid.GetReturn(beam) != ScanGrid::NoReturn || !IsCovered(map, surface, beam))
      {
        continue;
      }
      const int id = turn * map.Grid.GetNumberOfBeams() + number;
      if (gaps.GetGroup(beam) == ClosableGaps::NoGroup || named.count(id) == 0)
      {
        verdict.Add("miss", map.Grid.Describe(beam) + ", meets surface");
        continue;
      }
      closed.insert(id);
      groups.insert(gaps.GetGroup(beam));
      if (ideal)
      {
        JudgePassage(map, *ideal, surface, beam, verdict);
      }
    }
  }
  const std::set<int> counted = GetFieldNumbers(map.Map, "NumberOfClosedGaps");
  if (closed != named ||
    (counted.empty() ? 0 : *counted.begin()) != static_cast<int>(groups.size()))
  {
    verdict.Add("closed gap",
      std::to_string(named.size()) + " beams are named, and " + std::to_string(closed.size()) +
        " are closed in " + std::to_string(groups.size()) + " gaps");
  }
}
