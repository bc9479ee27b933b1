// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dReturns.h"

#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dPooledArray.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

namespace
{
// The beams of a turn that returned.
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

// `beamOf` tells the beam of a return. One loop for each array keeps them simple enough to be
// vectorized, where all beams of the turn returned at least.
template <typename BeamOf>
void FillArrays(const lms3dTurn& turn, int count, std::size_t slot, const lms3dReturns& returns,
  const BeamOf& beamOf)
{
  FillEach(returns.Range + slot, count, [&](int i) { return turn.Ranges[beamOf(i)]; });
  const double* alpha = turn.Geometry.GetAlphaAngles().data();
  FillEach(
    returns.Alpha + slot, count, [&](int i) { return static_cast<float>(alpha[beamOf(i)]); });
  const int firstBeam = turn.Number * turn.Geometry.GetNumberOfBeams();
  FillEach(returns.BeamId + slot, count, [&](int i) { return firstBeam + beamOf(i); });
  FillEach(returns.CellId + slot, count,
    [&](int i)
    {
      const int beam = beamOf(i);
      return turn.Mesh ? turn.Mesh->GetCell(turn.Triangles[beam]) : turn.Cells[beam];
    });
  std::fill_n(
    returns.Beta + slot, count, static_cast<float>(turn.Geometry.GetBetaAngles()[turn.Number]));
  const vtkTypeInt32 first = static_cast<vtkTypeInt32>(slot);
  FillEach(returns.VertexOffset + slot, count, [&](int i) { return first + i; });
  FillEach(returns.VertexPoint + slot, count, [&](int i) { return first + i; });
}

void Locate(const lms3dTurn& turn, int count, std::size_t slot, const lms3dReturns& returns,
  const double* cosines, const double* sines)
{
  const lms3dReturnsOfTurn located = { cosines, sines, returns.Range + slot, count,
    turn.Directions.GetFanAxis(turn.Number).data(), turn.Directions.GetUp().data(),
    turn.Position.data() };
  lms3dGetPacketKernels().Locate(located, returns.Point + 3 * slot);
}

void FillAll(const lms3dTurn& turn, std::size_t slot, const lms3dReturns& returns)
{
  const int count = turn.Geometry.GetNumberOfBeams();
  FillArrays(turn, count, slot, returns, [](int i) { return i; });
  Locate(turn, count, slot, returns, turn.Geometry.GetAlphaCosines().data(),
    turn.Geometry.GetAlphaSines().data());
}

void FillSome(const lms3dTurn& turn, const std::vector<int>& hits, std::size_t slot,
  const lms3dReturns& returns)
{
  const int count = static_cast<int>(hits.size());
  FillArrays(turn, count, slot, returns, [&hits](int i) { return hits[i]; });
  std::vector<double> cosines(count), sines(count);
  for (int i = 0; i < count; ++i)
  {
    cosines[i] = turn.Geometry.GetAlphaCosine(hits[i]);
    sines[i] = turn.Geometry.GetAlphaSine(hits[i]);
  }
  Locate(turn, count, slot, returns, cosines.data(), sines.data());
}
} // namespace

lms3dReturns::lms3dReturns(lms3dMemoryPool& pool, vtkIdType count)
  : Points(lms3dMakeArray<vtkDoubleArray>(pool, "Points", count, 3))
  , Ranges(lms3dMakeArray<vtkDoubleArray>(pool, "Range", count))
  , Alphas(lms3dMakeArray<vtkFloatArray>(pool, "Alpha", count))
  , Betas(lms3dMakeArray<vtkFloatArray>(pool, "Beta", count))
  , BeamIds(lms3dMakeArray<vtkIntArray>(pool, "BeamId", count))
  , CellIds(lms3dMakeArray<vtkIdTypeArray>(pool, "CellId", count))
  , VertexOffsets(lms3dMakeArray<vtkTypeInt32Array>(pool, "Offsets", count + 1))
  , VertexPoints(lms3dMakeArray<vtkTypeInt32Array>(pool, "Connectivity", count))
  , Point(this->Points->GetPointer(0))
  , Range(this->Ranges->GetPointer(0))
  , Alpha(this->Alphas->GetPointer(0))
  , Beta(this->Betas->GetPointer(0))
  , BeamId(this->BeamIds->GetPointer(0))
  , CellId(this->CellIds->GetPointer(0))
  , VertexOffset(this->VertexOffsets->GetPointer(0))
  , VertexPoint(this->VertexPoints->GetPointer(0))
{
}

void lms3dReturns::MoveTo(vtkPolyData* scan) const
{
  vtkNew<vtkPoints> points;
  points->SetData(this->Points);
  scan->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(this->VertexOffsets, this->VertexPoints);
  scan->SetVerts(vertices);
  vtkPointData* pointData = scan->GetPointData();
  pointData->SetScalars(this->Ranges);
  pointData->AddArray(this->Alphas);
  pointData->AddArray(this->Betas);
  pointData->AddArray(this->BeamIds);
  pointData->AddArray(this->CellIds);
}

void lms3dTurn::Fill(std::size_t slot, const lms3dReturns& returns) const
{
  const std::vector<int> hits = GetHits(this->Triangles, this->Geometry.GetNumberOfBeams());
  if (static_cast<int>(hits.size()) == this->Geometry.GetNumberOfBeams())
  {
    FillAll(*this, slot, returns);
  }
  else
  {
    FillSome(*this, hits, slot, returns);
  }
}
