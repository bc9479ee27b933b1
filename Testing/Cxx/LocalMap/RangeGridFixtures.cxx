// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/RangeGridFixtures.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
GridContent GetContent(const lms3dRangeGrid& grid, const Returns& returns)
{
  GridContent content;
  for (int turn = -2; turn < Returns::Turns + 3; ++turn)
  {
    content.Ranges.insert(
      content.Ranges.end(), grid.GetRanges(turn) - 2, grid.GetRanges(turn) + Returns::Beams + 2);
    content.Vertices.insert(content.Vertices.end(), grid.GetVertices(turn) - 2,
      grid.GetVertices(turn) + Returns::Beams + 2);
  }
  for (int turn = 0; turn <= Returns::Turns; ++turn)
  {
    content.FirstVertices.push_back(grid.GetFirstVertex(turn));
  }
  for (std::int32_t found : grid.GetReturns())
  {
    content.BeamsOfVertices.push_back(returns.BeamIds[found]);
  }
  content.RangesOfPoles = grid.GetRangesOfPoles();
  for (std::vector<double>& ofPole : content.RangesOfPoles)
  {
    std::sort(ofPole.begin(), ofPole.end());
  }
  return content;
}
} // namespace

Returns::Returns()
{
  for (int id = 0; static_cast<int>(this->BeamIds.size()) < Count; ++id)
  {
    if (id % (Beams + 2) != 17)
    {
      this->BeamIds.push_back(id);
      this->Ranges.push_back(2.0 + std::sin(id) + 1e-5 * id);
    }
  }
}

Returns Returns::Sort(const std::vector<std::size_t>& order) const
{
  Returns sorted = *this;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    sorted.Ranges[i] = this->Ranges[order[i]];
    sorted.BeamIds[i] = this->BeamIds[order[i]];
  }
  return sorted;
}

Returns Returns::GetFirst(int count) const
{
  Returns first = *this;
  first.Ranges.resize(count);
  first.BeamIds.resize(count);
  return first;
}

Returns Returns::LeaveOut(int index) const
{
  Returns others = *this;
  others.Ranges.erase(others.Ranges.begin() + index);
  others.BeamIds.erase(others.BeamIds.begin() + index);
  return others;
}

Returns Returns::Reverse() const
{
  Returns reversed = *this;
  std::reverse(reversed.Ranges.begin(), reversed.Ranges.end());
  std::reverse(reversed.BeamIds.begin(), reversed.BeamIds.end());
  return reversed;
}

GridContent RangeGridBuilder::Build(const Returns& returns)
{
  tbb::task_arena(this->Threads)
    .execute(
      [&]
      {
        this->Grid.Build(this->Geometry, returns.Ranges.data(), returns.BeamIds.data(),
          static_cast<std::int64_t>(returns.BeamIds.size()));
      });
  return GetContent(this->Grid, returns);
}

std::string RangeGridBuilder::GetError(const Returns& returns)
{
  try
  {
    this->Build(returns);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}
