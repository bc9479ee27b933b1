// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRangeGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

lms3dRangeGrid::lms3dRangeGrid(
  lms3dScanGeometry geometry, const double* ranges, const int* beamIds, std::int64_t count)
  : Geometry(std::move(geometry))
  , Closed(this->Geometry.IsClosed())
{
  this->Place(ranges, beamIds, count);
  for (int beam = 0; beam < this->GetNumberOfBeams(); ++beam)
  {
    if (this->Geometry.IsPole(beam))
    {
      this->JoinPole(beam);
    }
  }
  this->NumberVertices();
}

std::ptrdiff_t lms3dRangeGrid::GetPlace(int turn, int beam) const
{
  const int turns = this->GetNumberOfTurns();
  if (this->Closed)
  {
    turn = turn < 0 ? turn + turns : (turn >= turns ? turn - turns : turn);
  }
  if (turn < 0 || turn >= turns || beam < 0 || beam >= this->GetNumberOfBeams())
  {
    return -1;
  }
  return static_cast<std::ptrdiff_t>(turn) * this->GetNumberOfBeams() + beam;
}

// Vertices hold the number of the return until they are numbered themselves.
void lms3dRangeGrid::Place(const double* ranges, const int* beamIds, std::int64_t count)
{
  const std::int64_t places =
    static_cast<std::int64_t>(this->GetNumberOfBeams()) * this->GetNumberOfTurns();
  this->Ranges.assign(places, 0.0);
  this->Vertices.assign(places, NoVertex);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const int place = beamIds[i];
    const std::string words = "Return " + std::to_string(i) + " of the scan has ";
    if (place < 0 || place >= places)
    {
      throw std::runtime_error(words + "the BeamId " + std::to_string(place) + "; 0 to " +
        std::to_string(places - 1) + " are expected from AlphaAngles and BetaAngles.");
    }
    if (this->Vertices[place] != NoVertex)
    {
      throw std::runtime_error(words + "the BeamId " + std::to_string(place) +
        " of an earlier one. Give each beam at most one return.");
    }
    if (!(ranges[i] > 0.0) || !std::isfinite(ranges[i]))
    {
      throw std::runtime_error(words + "the Range " + std::to_string(ranges[i]) +
        "; a finite number of metres above 0 is expected. Remove beams that gave no return.");
    }
    this->Ranges[place] = ranges[i];
    this->Vertices[place] = i;
  }
}

void lms3dRangeGrid::JoinPole(int beam)
{
  std::vector<std::pair<double, std::int64_t>> returns;
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    if (this->HasReturn(turn, beam))
    {
      returns.emplace_back(this->GetRange(turn, beam), this->GetVertex(turn, beam));
    }
  }
  if (returns.empty())
  {
    return;
  }
  const auto median = returns.begin() + returns.size() / 2;
  std::nth_element(returns.begin(), median, returns.end());
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    this->Ranges[this->GetPlace(turn, beam)] = median->first;
    this->Vertices[this->GetPlace(turn, beam)] = median->second;
  }
}

void lms3dRangeGrid::NumberVertices()
{
  std::vector<std::int64_t> vertexOfReturn;
  for (std::int64_t& vertex : this->Vertices)
  {
    if (vertex == NoVertex)
    {
      continue;
    }
    if (vertex >= static_cast<std::int64_t>(vertexOfReturn.size()))
    {
      vertexOfReturn.resize(vertex + 1, NoVertex);
    }
    std::int64_t& number = vertexOfReturn[vertex];
    if (number == NoVertex)
    {
      number = static_cast<std::int64_t>(this->Returns.size());
      this->Returns.push_back(vertex);
    }
    vertex = number;
  }
}
