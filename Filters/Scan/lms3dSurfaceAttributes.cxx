// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dSurfaceAttributes.h"

#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dVector.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dArray.h"
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
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace
{
const char* const BeamIds = "BeamId";

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

/// The unit normals of triangles, towards the sensor. Keeps the last one, because neighbouring beams
/// hit the same triangle.
class SensorFacingNormals
{
public:
  SensorFacingNormals(const lms3dTriangleMesh& mesh, const lms3dVector& position)
    : Mesh(mesh)
    , Position(position)
  {
  }

  const lms3dVector& Get(std::int32_t triangle)
  {
    if (triangle != this->Triangle)
    {
      this->Triangle = triangle;
      this->Normal = this->Compute(lms3dGetCorners(this->Mesh, triangle));
    }
    return this->Normal;
  }

private:
  // Double precision would lose the normals of needles.
  lms3dVector Compute(const lms3dCorners& corners) const
  {
    const double* position = this->Position.data();
    const lms3dDoubleDoublePlane plane =
      lms3dGetPacketKernels().MakeDoubleDoublePlane(corners.data(), position);
    const lms3dVector normal =
      lms3dNormalize({ plane.Normal[0].High, plane.Normal[1].High, plane.Normal[2].High });
    return lms3dGetSide(corners, position) < 0 ? lms3dScale(normal, -1.0) : normal;
  }

  const lms3dTriangleMesh& Mesh;
  const lms3dVector& Position;
  std::int32_t Triangle = lms3dBeamPacket::NoTriangle;
  lms3dVector Normal{};
};

// An arc cosine would lose half of the digits near 0.
double GetIncidence(const lms3dVector& direction, const lms3dVector& normal)
{
  return lms3dDegreesPerRadian *
    std::atan2(
      lms3dGetLength(lms3dCross(direction, normal)), std::abs(lms3dDot(direction, normal)));
}

void AddNormals(const lms3dSurfaceHits& hits, const std::vector<int>& beams, vtkFieldData* data)
{
  const std::size_t count = beams.size();
  const auto normals = lms3dMakeArray<vtkFloatArray>("Normals", count, 3);
  const auto incidences = lms3dMakeArray<vtkFloatArray>("Incidence", count);
  float* normalOf = normals->GetPointer(0);
  float* incidenceOf = incidences->GetPointer(0);
  const lms3dBeamDirections directions(hits.Geometry, hits.Pose);
  const int beamsOfTurn = hits.Geometry.GetNumberOfBeams();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      SensorFacingNormals facing(hits.Mesh, hits.Pose.Position);
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const int beam = beams[i];
        const lms3dVector& normal = facing.Get(hits.Triangles[beam]);
        std::transform(normal.begin(), normal.end(), normalOf + 3 * i,
          [](double x) { return static_cast<float>(x); });
        incidenceOf[i] = static_cast<float>(
          GetIncidence(directions.GetDirection(beam / beamsOfTurn, beam % beamsOfTurn), normal));
      }
    });
  data->AddArray(normals);
  data->AddArray(incidences);
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

void lms3dAddSurfaceAttributes(
  const lms3dSurfaceHits& hits, vtkDataObject* scene, bool hasGlobalIds, vtkFieldData* data)
{
  const std::vector<int> beams = GetBeams(hits.Triangles);
  AddNormals(hits, beams, data);
  std::vector<vtkIdType> cells(beams.size());
  std::transform(beams.begin(), beams.end(), cells.begin(),
    [&hits](int beam) { return hits.Mesh.GetCell(hits.Triangles[beam]); });
  lms3dCopyCellData(scene, hasGlobalIds, std::move(cells), data);
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
