// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include "Device/lms3dScanInput.h"
#include "Geometry/lms3dWideLoops.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
constexpr std::int32_t NoReturn = -1;
constexpr double MaximumRange = std::numeric_limits<double>::max();
constexpr std::int64_t MinimumReturnsPerTask = 16384;

// Whether ranges are good and the beams of returns grow. The loops have no branches, so that
// the compiler makes them loops over vectors.
LMS3D_WIDE_LOOPS
bool AreInOrder(const double* ranges, const int* beamIds, std::int64_t first, std::int64_t end)
{
  std::int64_t bad = 0;
  for (std::int64_t i = first; i < end; ++i)
  {
    bad += (ranges[i] > 0.0) & (ranges[i] <= MaximumRange) ? 0 : 1;
  }
  int unsorted = 0;
  for (std::int64_t i = std::max<std::int64_t>(first, 1); i < end; ++i)
  {
    unsorted |= beamIds[i] > beamIds[i - 1] ? 0 : 1;
  }
  return bad == 0 && unsorted == 0;
}
} // namespace

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

void lms3dRangeGrid::AssignReturns(const double* ranges, const int* beamIds, std::int64_t count)
{
  const std::int64_t beams = this->Geometry->CountBeamsOfAllTurns();
  if (this->AreSorted(ranges, beamIds, count))
  {
    this->AssignSortedReturns(beamIds, count);
    return;
  }
  this->ReturnOfBeam.assign(beams, NoReturn);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const int beam = beamIds[i];
    if (beam < 0 || beam >= beams || this->ReturnOfBeam[beam] != NoReturn ||
      !(ranges[i] > 0.0 && ranges[i] <= MaximumRange))
    {
      lms3dThrowBadReturn(i, ranges[i], beam, beams);
    }
    this->ReturnOfBeam[beam] = static_cast<std::int32_t>(i);
  }
}

// Whether all returns are good and in the order of their beams. Then no beam has two of them.
bool lms3dRangeGrid::AreSorted(const double* ranges, const int* beamIds, std::int64_t count) const
{
  const auto areSorted = [&](const tbb::blocked_range<std::int64_t>& part, bool before)
  { return before && AreInOrder(ranges, beamIds, part.begin(), part.end()); };
  return count == 0 ||
    (beamIds[0] >= 0 && beamIds[count - 1] < this->Geometry->CountBeamsOfAllTurns() &&
      tbb::parallel_reduce(tbb::blocked_range<std::int64_t>(0, count, MinimumReturnsPerTask), true,
        areSorted, [](bool a, bool b) { return a && b; }));
}

// Each return sets its beam, and the beams since the return before.
void lms3dRangeGrid::AssignSortedReturns(const int* beamIds, std::int64_t count)
{
  this->ReturnOfBeam.resize(this->Geometry->CountBeamsOfAllTurns());
  const auto assign = [&](const tbb::blocked_range<std::int64_t>& part)
  {
    int next = part.begin() > 0 ? beamIds[part.begin() - 1] + 1 : 0;
    for (std::int64_t i = part.begin(); i < part.end(); ++i)
    {
      while (next < beamIds[i])
      {
        this->ReturnOfBeam[next++] = NoReturn;
      }
      this->ReturnOfBeam[next++] = static_cast<std::int32_t>(i);
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, MinimumReturnsPerTask), assign);
  const std::ptrdiff_t end = count > 0 ? beamIds[count - 1] + 1 : 0;
  std::fill(this->ReturnOfBeam.begin() + end, this->ReturnOfBeam.end(), NoReturn);
}

// Keeps the return of median range in the first turn and removes the others.
void lms3dRangeGrid::CollapsePole(int beam, const double* ranges)
{
  std::vector<std::pair<double, std::int32_t>> returns;
  std::vector<double>& all = this->RangesOfPoles.emplace_back();
  for (int turn = 0; turn < this->GetNumberOfTurns(); ++turn)
  {
    const std::size_t index = static_cast<std::size_t>(turn) * this->GetNumberOfBeams() + beam;
    const std::int32_t found = std::exchange(this->ReturnOfBeam[index], NoReturn);
    if (found != NoReturn)
    {
      returns.emplace_back(ranges[found], found);
      all.push_back(ranges[found]);
    }
  }
  if (!returns.empty())
  {
    const auto median = returns.begin() + returns.size() / 2;
    std::nth_element(returns.begin(), median, returns.end());
    this->ReturnOfBeam[beam] = median->second;
  }
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
