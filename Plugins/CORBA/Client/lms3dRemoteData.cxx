// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRemoteData.h"

#include "lms3dGridGeometry.h"
#include "lms3dScanFieldData.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
template <typename Array>
void MakeRoom(Array* array, const char* name, std::size_t count, int components = 1)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
}

std::size_t CountReturns(const std::vector<float>& ranges)
{
  return static_cast<std::size_t>(
    std::count_if(ranges.begin(), ranges.end(), [](float range) { return range > 0.0f; }));
}

/// The returns of a scan: a slot for each in every array.
struct Returns
{
  explicit Returns(std::size_t count)
  {
    MakeRoom(this->Points.GetPointer(), "Points", count, 3);
    MakeRoom(this->Ranges.GetPointer(), "Range", count);
    MakeRoom(this->Alphas.GetPointer(), "Alpha", count);
    MakeRoom(this->Betas.GetPointer(), "Beta", count);
    MakeRoom(this->BeamIds.GetPointer(), "BeamId", count);
  }

  void MoveTo(vtkPolyData* scan) const
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Points);
    scan->SetPoints(points);
    scan->GetPointData()->SetScalars(this->Ranges);
    scan->GetPointData()->AddArray(this->Alphas);
    scan->GetPointData()->AddArray(this->Betas);
    scan->GetPointData()->AddArray(this->BeamIds);
    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(this->Ranges->GetNumberOfValues(), this->Ranges->GetNumberOfValues());
    for (vtkIdType i = 0; i < this->Ranges->GetNumberOfValues(); ++i)
    {
      vertices->InsertNextCell(1, &i);
    }
    scan->SetVerts(vertices);
  }

  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkDoubleArray> Ranges;
  vtkNew<vtkFloatArray> Alphas;
  vtkNew<vtkFloatArray> Betas;
  vtkNew<vtkIntArray> BeamIds;
};

void FillReturns(const std::vector<float>& ranges, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const Returns& returns)
{
  const lms3dBeamDirections directions(geometry, pose);
  const int beams = geometry.GetNumberOfBeams();
  vtkIdType slot = 0;
  for (std::size_t id = 0; id < ranges.size(); ++id)
  {
    const double range = ranges[id];
    if (range > 0.0)
    {
      const int turn = static_cast<int>(id) / beams;
      const int beam = static_cast<int>(id) % beams;
      const std::array<double, 3> direction = directions.GetDirection(turn, beam);
      for (int axis = 0; axis < 3; ++axis)
      {
        returns.Points->SetValue(3 * slot + axis, pose.Position[axis] + range * direction[axis]);
      }
      returns.Ranges->SetValue(slot, range);
      returns.Alphas->SetValue(slot, static_cast<float>(geometry.GetAlphaAngles()[beam]));
      returns.Betas->SetValue(slot, static_cast<float>(geometry.GetBetaAngles()[turn]));
      returns.BeamIds->SetValue(slot, static_cast<int>(id));
      ++slot;
    }
  }
}

vtkNew<vtkCellArray> MakeTriangles(const std::vector<std::uint32_t>& numbers)
{
  vtkNew<vtkTypeInt64Array> connectivity;
  MakeRoom(connectivity.GetPointer(), "Connectivity", numbers.size());
  std::copy(numbers.begin(), numbers.end(), connectivity->GetPointer(0));
  vtkNew<vtkTypeInt64Array> offsets;
  const std::size_t count = numbers.size() / 3;
  MakeRoom(offsets.GetPointer(), "Offsets", count + 1);
  for (std::size_t i = 0; i <= count; ++i)
  {
    offsets->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt64>(3 * i));
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, connectivity);
  return triangles;
}

vtkNew<vtkDoubleArray> MakeRanges(const std::vector<double>& points, const LMS3D::Vector3& sensor)
{
  vtkNew<vtkDoubleArray> ranges;
  MakeRoom(ranges.GetPointer(), "Range", points.size() / 3);
  for (std::size_t i = 0; i < points.size() / 3; ++i)
  {
    const double* point = points.data() + 3 * i;
    ranges->SetValue(static_cast<vtkIdType>(i),
      std::hypot(point[0] - sensor.x, point[1] - sensor.y, point[2] - sensor.z));
  }
  return ranges;
}
} // namespace

void lms3dFillScan(const lms3dRemoteScan& remote, vtkPolyData* scan)
{
  const lms3dScanGeometry geometry = lms3dGetGeometry(remote.Header.settings);
  const lms3dPose pose = lms3dGetPose(remote.Header.sensorPose);
  const Returns returns(CountReturns(remote.Ranges));
  FillReturns(remote.Ranges, geometry, pose, returns);
  returns.MoveTo(scan);
  lms3dAddFieldData(geometry, pose, scan);
}

void lms3dFillMap(const lms3dRemoteScan& remote, vtkPolyData* map)
{
  vtkNew<vtkDoubleArray> coordinates;
  MakeRoom(coordinates.GetPointer(), "Points", remote.MapPoints.size() / 3, 3);
  std::copy(remote.MapPoints.begin(), remote.MapPoints.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  map->SetPoints(points);
  map->SetPolys(MakeTriangles(remote.MapTriangles));
  map->GetPointData()->SetScalars(MakeRanges(remote.MapPoints, remote.Header.sensorPose.position));
}
