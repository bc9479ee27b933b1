// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteData.h"

#include "Common/lms3dGridGeometry.h"
#include "Device/lms3dScanFieldData.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeUInt64Array.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace
{
template <typename ArrayT>
vtkNew<ArrayT> MakeArray(const char* name, vtkIdType count, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

// Cells of `size` points each.
vtkNew<vtkCellArray> MakeCells(vtkTypeInt32Array* points, int size)
{
  const vtkIdType count = points->GetNumberOfValues() / size;
  const auto offsets = MakeArray<vtkTypeInt32Array>("Offsets", count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(size * i));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, points);
  return cells;
}

void SetPoints(vtkDoubleArray* coordinates, vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  data->SetPoints(points);
}

void AddNumber(const char* name, CORBA::ULongLong number, vtkFieldData* fieldData)
{
  const auto array = MakeArray<vtkTypeUInt64Array>(name, 1);
  array->SetValue(0, number);
  fieldData->AddArray(array);
}

void AddHeader(const LMS3D::ScanHeader& header, vtkFieldData* fieldData)
{
  AddNumber("ScanNumber", header.number, fieldData);
  AddNumber("Incarnation", header.incarnation, fieldData);
  AddNumber("Generation", header.generation, fieldData);
  AddNumber("StartTime", header.startTime, fieldData);
  AddNumber("EndTime", header.endTime, fieldData);
  vtkNew<vtkStringArray> scene;
  scene->SetName("Scene");
  scene->InsertNextValue(header.scene.in());
  fieldData->AddArray(scene);
}

/// The arrays of a scan, with a tuple for each return.
struct Returns
{
  explicit Returns(vtkIdType count)
    : Points(MakeArray<vtkDoubleArray>("Points", count, 3))
    , Ranges(MakeArray<vtkDoubleArray>("Range", count))
    , Alphas(MakeArray<vtkFloatArray>("Alpha", count))
    , Betas(MakeArray<vtkFloatArray>("Beta", count))
    , BeamIds(MakeArray<vtkIntArray>("BeamId", count))
    , Vertices(MakeArray<vtkTypeInt32Array>("Connectivity", count))
  {
    std::iota(this->Vertices->GetPointer(0), this->Vertices->GetPointer(count), 0);
  }

  void MoveTo(vtkPolyData* scan) const
  {
    SetPoints(this->Points, scan);
    scan->SetVerts(MakeCells(this->Vertices, 1));
    vtkPointData* pointData = scan->GetPointData();
    pointData->SetScalars(this->Ranges);
    pointData->AddArray(this->Alphas);
    pointData->AddArray(this->Betas);
    pointData->AddArray(this->BeamIds);
  }

  const vtkNew<vtkDoubleArray> Points;
  const vtkNew<vtkDoubleArray> Ranges;
  const vtkNew<vtkFloatArray> Alphas;
  const vtkNew<vtkFloatArray> Betas;
  const vtkNew<vtkIntArray> BeamIds;
  const vtkNew<vtkTypeInt32Array> Vertices;
};

// Raw pointers, because calls of ParaView's VTK for each value are slow.
void FillReturns(const std::vector<float>& ranges, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const Returns& returns)
{
  const lms3dBeamDirections directions(geometry, pose);
  const int beams = geometry.GetNumberOfBeams();
  double* point = returns.Points->GetPointer(0);
  double* range = returns.Ranges->GetPointer(0);
  float* alpha = returns.Alphas->GetPointer(0);
  float* beta = returns.Betas->GetPointer(0);
  int* beamId = returns.BeamIds->GetPointer(0);
  for (int id = 0; id < static_cast<int>(ranges.size()); ++id)
  {
    if (ranges[id] == 0.0F)
    {
      continue;
    }
    const int turn = id / beams;
    const int beam = id % beams;
    const std::array<double, 3> direction = directions.GetDirection(turn, beam);
    for (int axis = 0; axis < 3; ++axis)
    {
      *point++ = pose.Position[axis] + ranges[id] * direction[axis];
    }
    *range++ = ranges[id];
    *alpha++ = static_cast<float>(geometry.GetAlphaAngles()[beam]);
    *beta++ = static_cast<float>(geometry.GetBetaAngles()[turn]);
    *beamId++ = id;
  }
}

vtkNew<vtkDoubleArray> MakeRanges(const std::vector<double>& points, const LMS3D::Vector3& sensor)
{
  const vtkIdType count = static_cast<vtkIdType>(points.size() / 3);
  auto ranges = MakeArray<vtkDoubleArray>("Range", count);
  double* range = ranges->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* point = points.data() + 3 * i;
    range[i] = std::hypot(point[0] - sensor.x, point[1] - sensor.y, point[2] - sensor.z);
  }
  return ranges;
}
} // namespace

void lms3dFillScan(const lms3dRemoteScan& remote, vtkPolyData* scan)
{
  const lms3dScanGeometry geometry = lms3dGetGeometry(remote.Header.settings);
  const lms3dPose pose = lms3dGetPose(remote.Header.sensorPose);
  const Returns returns(remote.Header.returns);
  FillReturns(remote.Ranges, geometry, pose, returns);
  returns.MoveTo(scan);
  lms3dAddFieldData(geometry, pose, scan);
  AddHeader(remote.Header, scan->GetFieldData());
}

void lms3dFillMap(const lms3dRemoteScan& remote, vtkPolyData* map)
{
  const auto points = MakeArray<vtkDoubleArray>("Points", remote.Header.mapPoints, 3);
  std::copy(remote.MapPoints.begin(), remote.MapPoints.end(), points->GetPointer(0));
  SetPoints(points, map);
  const auto corners = MakeArray<vtkTypeInt32Array>(
    "Connectivity", static_cast<vtkIdType>(remote.MapTriangles.size()));
  std::copy(remote.MapTriangles.begin(), remote.MapTriangles.end(), corners->GetPointer(0));
  map->SetPolys(MakeCells(corners, 3));
  map->GetPointData()->SetScalars(MakeRanges(remote.MapPoints, remote.Header.sensorPose.position));
  AddHeader(remote.Header, map->GetFieldData());
}
