// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

void lms3dRangeGrid::Build(
  const lms3dScanGeometry& geometry, const double* ranges, const int* beamIds, std::int64_t count)
{
  this->Geometry = &geometry;
  this->Closed = geometry.IsClosed();
  this->HasFilled = false;
  this->AssignReturns(ranges, beamIds, count);
  this->Poles.clear();
  this->RangesOfPoles.clear();
  for (int beam = 0; beam < this->GetNumberOfBeams(); ++beam)
  {
    if (geometry.IsPole(beam))
    {
      this->Poles.push_back(beam);
      this->CollapsePole(beam, ranges);
    }
  }

  this->CountVertices();
  this->Returns.resize(this->FirstVertices.back());
  this->Ranges.SetShape(this->GetNumberOfTurns(), this->GetNumberOfBeams());
  this->Vertices.SetShape(this->GetNumberOfTurns(), this->GetNumberOfBeams());
  tbb::parallel_for(0, this->GetNumberOfTurns(), [&](int turn) { this->FillTurn(turn, ranges); });
  this->HasPole = false;
  for (int beam : this->Poles)
  {
    this->CopyPoleToTurns(beam);
    this->HasPole |= this->HasReturn(0, beam);
  }
  this->FillHalo();
}

void lms3dRangeGrid::Fill(const std::vector<lms3dFilledBeam>& beams)
{
  this->HasFilled = !beams.empty();
  for (const lms3dFilledBeam& filled : beams)
  {
    this->Ranges.GetRow(filled.Turn)[filled.Beam] = filled.Range;
    this->Vertices.GetRow(filled.Turn)[filled.Beam] = NoVertex;
  }
  if (this->HasFilled)
  {
    this->FillHalo();
  }
}

void lms3dRangeGrid::FillHalo()
{
  this->FillHaloBeams(0, -1);
  this->FillHaloBeams(this->GetNumberOfBeams() - 1, 1);
  this->Ranges.FillHalo(this->Closed);
  this->Vertices.FillHalo(this->Closed);
}

const std::int32_t* lms3dRangeGrid::GetReturnsOfTurn(int turn) const
{
  return this->ReturnOfBeam.data() + static_cast<std::ptrdiff_t>(turn) * this->GetNumberOfBeams();
}

double lms3dRangeGrid::LimitToLargestRange(double length) const
{
  double largest = 0.0;
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    const double* const ranges = this->GetRanges(turn);
    for (int beam = 0; beam < this->GetNumberOfBeams(); ++beam)
    {
      if (ranges[beam] >= length)
      {
        return length;
      }
      largest = std::max(largest, ranges[beam]);
    }
  }
  return std::min(length, largest);
}

void lms3dRangeGrid::CountVertices()
{
  std::vector<std::int32_t>& first = this->FirstVertices;
  first.assign(this->GetNumberOfTurns() + 1, 0);
  tbb::parallel_for(0, this->GetNumberOfTurns(),
    [&](int turn)
    {
      const std::int32_t* returns = this->GetReturnsOfTurn(turn);
      std::int32_t found = 0;
      for (int beam = 0; beam < this->GetNumberOfBeams(); ++beam)
      {
        found += returns[beam] != NoReturn ? 1 : 0;
      }
      first[turn + 1] = found;
    });
  std::partial_sum(first.begin(), first.end(), first.begin());
}

void lms3dRangeGrid::FillTurn(int turn, const double* ranges)
{
  const std::int32_t* const returns = this->GetReturnsOfTurn(turn);
  double* const range = this->Ranges.GetRow(turn);
  std::int32_t* const vertex = this->Vertices.GetRow(turn);
  std::int32_t next = this->FirstVertices[turn];
  const int beams = this->GetNumberOfBeams();
  for (int beam = 0; beam < beams;)
  {
    const std::int32_t found = returns[beam];
    if (found == NoReturn)
    {
      range[beam] = 0.0;
      vertex[beam++] = NoVertex;
      continue;
    }
    // Most returns follow each other. They are copied together.
    int count = 1;
    while (beam + count < beams && returns[beam + count] == found + count)
    {
      ++count;
    }
    std::copy_n(ranges + found, count, range + beam);
    std::iota(vertex + beam, vertex + beam + count, next);
    std::iota(this->Returns.begin() + next, this->Returns.begin() + next + count, found);
    next += count;
    beam += count;
  }
}

void lms3dRangeGrid::CopyPoleToTurns(int beam)
{
  for (int turn = 1; turn < this->GetNumberOfTurns(); ++turn)
  {
    this->Ranges.GetRow(turn)[beam] = this->GetRange(0, beam);
    this->Vertices.GetRow(turn)[beam] = this->GetVertex(0, beam);
  }
}

// Fills the halo beside the first or the last beam.
void lms3dRangeGrid::FillHaloBeams(int end, int outwards)
{
  const bool goesOn = this->Closed && this->Geometry->IsPole(end);
  for (int distance : { 1, 2 })
  {
    const int opposite = end - distance * outwards;
    const bool isInside = opposite >= 0 && opposite < this->GetNumberOfBeams();
    for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
    {
      this->Ranges.GetRow(turn)[end + distance * outwards] =
        goesOn && isInside ? this->GetOppositeRange(turn, opposite) : 0.0;
    }
  }
}

double lms3dRangeGrid::GetOppositeRange(int turn, int beam) const
{
  const int turns = this->GetNumberOfTurns();
  return std::min(this->GetRange((turn + turns / 2) % turns, beam),
    this->GetRange((turn + (turns + 1) / 2) % turns, beam));
}
