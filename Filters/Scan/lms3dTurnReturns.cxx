// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dTurnReturns.h"

#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dPacketKernels.h"

#include <algorithm>
#include <vector>

namespace
{
// From this mean length on, it pays to fill the arrays run by run.
constexpr int MinimumRunLength = 8;

// A run is a number of neighbouring beams with a return, between beams without one.
int CountRuns(const std::int32_t* triangles, int count)
{
  // Compilers vectorize a count that is as wide as the elements.
  std::int32_t runs = triangles[0] != lms3dBeamPacket::NoTriangle ? 1 : 0;
  for (int beam = 1; beam < count; ++beam)
  {
    const bool isFirst = (triangles[beam] != lms3dBeamPacket::NoTriangle) &
      (triangles[beam - 1] == lms3dBeamPacket::NoTriangle);
    runs += isFirst ? 1 : 0;
  }
  return runs;
}

// Returns the beams of a turn that gave a return.
std::vector<int> GetHits(const std::int32_t* triangles, int count)
{
  std::vector<int> hits(count);
  int found = 0;
  for (int beam = 0; beam < count; ++beam)
  {
    hits[found] = beam;
    found += triangles[beam] != lms3dBeamPacket::NoTriangle ? 1 : 0;
  }
  hits.resize(found);
  return hits;
}

template <typename T, typename ValueOf>
void FillEach(T* out, int count, const ValueOf& valueOf)
{
  for (int i = 0; i < count; ++i)
  {
    out[i] = valueOf(i);
  }
}

// `beamOf` maps a return to its beam. The choice between the three sources stands outside the loops, so
// that the compiler can vectorize them.
template <typename BeamOf>
void FillCells(const lms3dTurn& turn, int count, vtkIdType* cellIds, const BeamOf& beamOf)
{
  if (!turn.Mesh)
  {
    FillEach(cellIds, count, [&](int i) { return turn.Cells[beamOf(i)]; });
  }
  else if (turn.Mesh->Cells.empty())
  {
    FillEach(cellIds, count, [&](int i) { return vtkIdType(turn.Triangles[beamOf(i)]); });
  }
  else
  {
    const std::int64_t* cells = turn.Mesh->Cells.data();
    FillEach(cellIds, count, [&](int i) { return vtkIdType(cells[turn.Triangles[beamOf(i)]]); });
  }
}

// `beamOf` maps a return to its beam. Each array has a loop of its own, so that the compiler can
// vectorize the loops, at least for a run.
template <typename BeamOf>
void FillArrays(const lms3dTurn& turn, int count, std::size_t slot, const lms3dReturns& returns,
  vtkIdType* cellIds, const BeamOf& beamOf)
{
  FillEach(returns.Range + slot, count, [&](int i) { return turn.Ranges[beamOf(i)]; });
  const double* alpha = turn.Geometry.GetAlphaAngles().data();
  FillEach(
    returns.Alpha + slot, count, [&](int i) { return static_cast<float>(alpha[beamOf(i)]); });
  const int firstBeam = turn.Number * turn.Geometry.GetNumberOfBeams();
  FillEach(returns.BeamId + slot, count, [&](int i) { return firstBeam + beamOf(i); });
  FillCells(turn, count, cellIds + slot, beamOf);
  std::fill_n(
    returns.Beta + slot, count, static_cast<float>(turn.Geometry.GetBetaAngles()[turn.Number]));
  const vtkIdType first = static_cast<vtkIdType>(slot);
  returns.FillVertices(first, first + count);
}

void Locate(const lms3dTurn& turn, int count, std::size_t slot, const lms3dReturns& returns,
  const double* cosines, const double* sines)
{
  const lms3dReturnsOfTurn located = { cosines, sines, returns.Range + slot, count,
    turn.Directions.GetFanAxis(turn.Number).data(), turn.Directions.GetUp().data(),
    turn.Position.data() };
  lms3dGetPacketKernels().Locate(located, returns.Point + 3 * slot);
}

void FillRun(const lms3dTurn& turn, int first, int count, std::size_t slot,
  const lms3dReturns& returns, vtkIdType* cellIds)
{
  FillArrays(turn, count, slot, returns, cellIds, [first](int i) { return first + i; });
  Locate(turn, count, slot, returns, turn.Geometry.GetAlphaCosines().data() + first,
    turn.Geometry.GetAlphaSines().data() + first);
}

void FillRuns(
  const lms3dTurn& turn, std::size_t slot, const lms3dReturns& returns, vtkIdType* cellIds)
{
  const std::int32_t* begin = turn.Triangles;
  const std::int32_t* end = begin + turn.Geometry.GetNumberOfBeams();
  const auto isReturn = [](std::int32_t triangle)
  { return triangle != lms3dBeamPacket::NoTriangle; };
  for (const std::int32_t* first = std::find_if(begin, end, isReturn); first != end;)
  {
    const std::int32_t* last = std::find_if_not(first, end, isReturn);
    const int count = static_cast<int>(last - first);
    FillRun(turn, static_cast<int>(first - begin), count, slot, returns, cellIds);
    slot += count;
    first = std::find_if(last, end, isReturn);
  }
}

void FillHits(const lms3dTurn& turn, const std::vector<int>& hits, std::size_t slot,
  const lms3dReturns& returns, vtkIdType* cellIds)
{
  const int count = static_cast<int>(hits.size());
  FillArrays(turn, count, slot, returns, cellIds, [&hits](int i) { return hits[i]; });
  std::vector<double> cosines(count), sines(count);
  for (int i = 0; i < count; ++i)
  {
    cosines[i] = turn.Geometry.GetAlphaCosine(hits[i]);
    sines[i] = turn.Geometry.GetAlphaSine(hits[i]);
  }
  Locate(turn, count, slot, returns, cosines.data(), sines.data());
}

// For beams that start anywhere, and at any angles of the platform.
void FillAnywhere(const lms3dTurn& turn, const std::vector<int>& hits, std::size_t slot,
  const lms3dReturns& returns, vtkIdType* cellIds)
{
  const int count = static_cast<int>(hits.size());
  FillArrays(turn, count, slot, returns, cellIds, [&hits](int i) { return hits[i]; });
  const lms3dTurnFrame frame = turn.Beams->GetFrame(turn.Number);
  const lms3dFan& fan = turn.Beams->GetFan();
  const double beta = turn.Geometry.GetBetaAngles()[turn.Number];
  for (int i = 0; i < count; ++i)
  {
    const lms3dVector point = lms3dAdd(frame.ToPoint(fan.Origins[hits[i]]),
      lms3dScale(frame.ToWorld(fan.Directions[hits[i]]), turn.Ranges[hits[i]]));
    std::copy(point.begin(), point.end(), returns.Point + 3 * (slot + i));
    returns.Beta[slot + i] = static_cast<float>(beta + fan.TurnedAngles[hits[i]]);
  }
}
} // namespace

void lms3dTurn::Fill(
  std::size_t slot, int count, const lms3dReturns& returns, vtkIdType* cellIds) const
{
  const int beams = this->Geometry.GetNumberOfBeams();
  if (this->Beams)
  {
    FillAnywhere(*this, GetHits(this->Triangles, beams), slot, returns, cellIds);
  }
  else if (count == beams)
  {
    FillRun(*this, 0, count, slot, returns, cellIds);
  }
  else if (MinimumRunLength * CountRuns(this->Triangles, beams) <= count)
  {
    FillRuns(*this, slot, returns, cellIds);
  }
  else
  {
    FillHits(*this, GetHits(this->Triangles, beams), slot, returns, cellIds);
  }
}
