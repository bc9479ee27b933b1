// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dSurfaceAttributes.h"

#include "Geometry/lms3dVector.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dArray.h"
#include "Scan/lms3dSurfaceNormals.h"
#include "Scene/lms3dJoinedArrays.h"
#include "Scene/lms3dSceneCellData.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace
{
const char* const BeamIds = "BeamId";

// The smallest part of a loop over returns that a thread takes.
constexpr std::size_t MinimumGrainSize = 4096;

// The beams that count, as BeamId numbers them.
std::vector<int> GetBeams(const lms3dHitTriangles& triangles)
{
  std::vector<int> beams;
  for (std::size_t beam = 0; beam < triangles.size(); ++beam)
  {
    if (triangles[beam] != lms3dBeamPacket::NoTriangle)
    {
      beams.push_back(static_cast<int>(beam));
    }
  }
  return beams;
}

/// The arrays of the hits; null if they are not wanted.
struct HitArrays
{
  float* Normals;
  float* Incidence;
  float* Intensity;
};

// Returns null if the array is not wanted.
float* AddFloats(
  bool isWanted, const char* name, std::size_t count, int components, vtkFieldData* data)
{
  if (!isWanted)
  {
    return nullptr;
  }
  const auto array = lms3dMakeArray<vtkFloatArray>(name, count, components);
  data->AddArray(array);
  return array->GetPointer(0);
}

void FillHit(const lms3dSurfaceHits& hits, int beam, std::size_t i, lms3dSurfaceNormals& normals,
  const HitArrays& arrays)
{
  const int beams = hits.Beams.GetGeometry().GetNumberOfBeams();
  const int turn = beam / beams;
  const int beamOfTurn = beam % beams;
  const std::int32_t triangle = hits.Triangles[beam];
  const lms3dVector& normal = normals.Get(triangle);
  if (arrays.Normals)
  {
    const lms3dVector facing = normals.GetFacing(triangle, hits.Beams.GetOrigin(turn, beamOfTurn));
    std::transform(facing.begin(), facing.end(), arrays.Normals + 3 * i,
      [](double x) { return static_cast<float>(x); });
  }
  const lms3dVector direction = hits.Beams.GetDirection(turn, beamOfTurn);
  if (arrays.Incidence)
  {
    arrays.Incidence[i] = static_cast<float>(lms3dGetIncidence(direction, normal));
  }
  if (arrays.Intensity)
  {
    arrays.Intensity[i] = static_cast<float>(
      hits.Surface.GetReflectance(triangle) * lms3dGetIncidenceCosine(direction, normal));
  }
}

void AddHitArrays(const lms3dSurfaceHits& hits, const lms3dSurfaceArrays& wanted,
  const std::vector<int>& beamIds, vtkFieldData* data)
{
  const std::size_t count = beamIds.size();
  const HitArrays arrays = { AddFloats(wanted.Attributes, "Normals", count, 3, data),
    AddFloats(wanted.Attributes || wanted.Incidence, "Incidence", count, 1, data),
    AddFloats(wanted.Intensity, "Intensity", count, 1, data) };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, MinimumGrainSize),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      lms3dSurfaceNormals normals(hits.Surface.Mesh);
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        FillHit(hits, beamIds[i], i, normals, arrays);
      }
    });
}

// VTK sends the types vtkIdType and long long as 32 bits and as vtkTypeInt64.
vtkSmartPointer<vtkAbstractArray> ToSendableType(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  if (type != VTK_ID_TYPE && type != VTK_LONG_LONG)
  {
    return array;
  }
  vtkNew<vtkTypeInt64Array> copy;
  copy->DeepCopy(array);
  copy->SetName(array->GetName());
  return copy.Get();
}

// Stands in for the missing returns of a process. VTK sends no arrays of a table without rows.
constexpr int NoBeam = -1;

void FillWithOneTuple(vtkAbstractArray* array)
{
  array->SetNumberOfTuples(1);
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    numbers->Fill(0.0);
  }
}

// `attributes` may get a tuple.
vtkSmartPointer<vtkTable> MakeTable(std::vector<int> beams, vtkFieldData* attributes)
{
  if (beams.empty() && attributes->GetNumberOfArrays() > 0)
  {
    beams.push_back(NoBeam);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      FillWithOneTuple(attributes->GetAbstractArray(i));
    }
  }
  const auto ids = lms3dMakeArray<vtkIntArray>(BeamIds, beams.size());
  std::copy(beams.begin(), beams.end(), ids->GetPointer(0));
  vtkNew<vtkTable> table;
  table->GetRowData()->AddArray(ids);
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (!table->GetRowData()->HasArray(array->GetName()))
    {
      table->GetRowData()->AddArray(ToSendableType(array));
    }
  }
  return table.Get();
}

// `found` are the beams with a return, in their order.
lms3dTupleSource MakeSource(vtkTable* table, const int* found, vtkIdType count)
{
  lms3dTupleSource source = { table->GetRowData(), table->GetNumberOfRows() };
  auto* beams = vtkIntArray::SafeDownCast(table->GetRowData()->GetArray(BeamIds));
  for (vtkIdType row = 0; row < source.Size && beams->GetValue(row) != NoBeam; ++row)
  {
    source.Add(
      row, std::distance(found, std::lower_bound(found, found + count, beams->GetValue(row))));
  }
  return source;
}

// Sources without returns count only if no source has any.
void KeepSourcesWithReturns(std::vector<lms3dTupleSource>& sources)
{
  const auto first = std::stable_partition(sources.begin(), sources.end(),
    [](const lms3dTupleSource& source) { return source.Tuples->GetNumberOfIds() > 0; });
  if (first != sources.begin())
  {
    sources.erase(first, sources.end());
  }
}

using Tables = std::vector<vtkSmartPointer<vtkDataObject>>;

void JoinTables(const Tables& tables, vtkPolyData* scan)
{
  std::vector<lms3dTupleSource> sources;
  auto* found = vtkIntArray::SafeDownCast(scan->GetPointData()->GetArray(BeamIds));
  // The last source wins, so the lowest rank comes last.
  for (auto table = tables.rbegin(); table != tables.rend(); ++table)
  {
    vtkTable* rows = vtkTable::SafeDownCast(*table);
    if (rows && rows->GetNumberOfRows() > 0)
    {
      sources.push_back(MakeSource(rows, found->GetPointer(0), found->GetNumberOfTuples()));
    }
  }
  KeepSourcesWithReturns(sources);
  lms3dJoinArrays(sources, scan->GetNumberOfPoints(), scan->GetPointData());
}
} // namespace

void lms3dAddSurfaceAttributes(const lms3dSurfaceHits& hits, const lms3dSurfaceArrays& wanted,
  vtkDataObject* scene, bool hasGlobalIds, vtkFieldData* data)
{
  const std::vector<int> beams = GetBeams(hits.Triangles);
  AddHitArrays(hits, wanted, beams, data);
  if (wanted.Attributes)
  {
    std::vector<vtkIdType> cells(beams.size());
    std::transform(beams.begin(), beams.end(), cells.begin(),
      [&hits](int beam) { return hits.Surface.Mesh.GetCell(hits.Triangles[beam]); });
    lms3dCopyCellData(scene, hasGlobalIds, std::move(cells), data);
  }
}

void lms3dGatherSurfaceAttributes(const lms3dProcesses& processes,
  const lms3dHitTriangles& triangles, vtkFieldData* attributes, vtkPolyData* scan)
{
  vtkSmartPointer<vtkTable> own;
  processes.RunCollectively([&] { own = MakeTable(GetBeams(triangles), attributes); });
  const Tables tables = processes.GatherToFirst(own);
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        JoinTables(tables, scan);
      }
    });
}
