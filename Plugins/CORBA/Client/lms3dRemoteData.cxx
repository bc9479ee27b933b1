// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteData.h"

#include "Client/lms3dRemoteFields.h"
#include "Common/lms3dGridGeometry.h"
#include "Device/lms3dBeams.h"
#include "Device/lms3dReturns.h"
#include "Pipeline/lms3dArray.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace
{
void AddHeader(const LMS3D::ScanHeader& header, vtkFieldData* fieldData)
{
  lms3dAddField("ScanNumber", header.number, fieldData);
  lms3dAddField("Incarnation", header.incarnation, fieldData);
  lms3dAddField("Generation", header.generation, fieldData);
  lms3dAddField("StartTime", header.startTime, fieldData);
  lms3dAddField("EndTime", header.endTime, fieldData);
  lms3dAddField("Scene", header.scene.in(), fieldData);
}

// Raw pointers, because calls of ParaView's VTK for each value are slow.
void FillReturns(const std::vector<float>& ranges, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dReturns& returns)
{
  const lms3dBeams laser(geometry, pose);
  const int beams = geometry.GetNumberOfBeams();
  double* point = returns.Point;
  double* range = returns.Range;
  float* alpha = returns.Alpha;
  float* beta = returns.Beta;
  int* beamId = returns.BeamId;
  for (int id = 0; id < static_cast<int>(ranges.size()); ++id)
  {
    if (ranges[id] == 0.0F)
    {
      continue;
    }
    const int turn = id / beams;
    const int beam = id % beams;
    const lms3dVector origin = laser.GetOrigin(turn, beam);
    const lms3dVector direction = laser.GetDirection(turn, beam);
    for (int axis = 0; axis < 3; ++axis)
    {
      *point++ = origin[axis] + ranges[id] * direction[axis];
    }
    *range++ = ranges[id];
    *alpha++ = static_cast<float>(geometry.GetAlphaAngles()[beam]);
    *beta++ = static_cast<float>(geometry.GetBetaAngles()[turn]);
    *beamId++ = id;
  }
}

void AddStatuses(const std::vector<std::uint8_t>& statuses, vtkFieldData* fieldData)
{
  const auto array = lms3dMakeArray<vtkUnsignedCharArray>("Status", statuses.size());
  std::copy(statuses.begin(), statuses.end(), array->GetPointer(0));
  lms3dAddHiddenArray(array, fieldData);
}

vtkSmartPointer<vtkDoubleArray> MakeRanges(
  const std::vector<double>& points, const LMS3D::Vector3& sensor)
{
  const vtkIdType count = static_cast<vtkIdType>(points.size() / 3);
  auto ranges = lms3dMakeArray<vtkDoubleArray>("Range", count);
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
  const lms3dScanGeometry geometry = lms3dGetGeometry(remote.Header.settings, remote.Device);
  const lms3dPose pose = lms3dGetPose(remote.Header.sensorPose);
  const lms3dReturns returns(remote.Header.returns);
  FillReturns(remote.Ranges, geometry, pose, returns);
  returns.FillVertices(0, remote.Header.returns);
  returns.MoveTo(geometry, pose, scan);
  AddHeader(remote.Header, scan->GetFieldData());
  if (remote.Device.computeStatus)
  {
    AddStatuses(remote.Statuses, scan->GetFieldData());
  }
}

void lms3dFillMap(const lms3dRemoteScan& remote, vtkPolyData* map)
{
  const auto points = lms3dMakeArray<vtkDoubleArray>("Points", remote.Header.mapPoints, 3);
  std::copy(remote.MapPoints.begin(), remote.MapPoints.end(), points->GetPointer(0));
  const auto corners = lms3dMakeArray<vtkTypeInt32Array>(
    "Connectivity", static_cast<vtkIdType>(remote.MapTriangles.size()));
  std::copy(remote.MapTriangles.begin(), remote.MapTriangles.end(), corners->GetPointer(0));
  lms3dSetTriangles(points, corners, map);
  map->GetPointData()->SetScalars(MakeRanges(remote.MapPoints, remote.Header.sensorPose.position));
  AddHeader(remote.Header, map->GetFieldData());
}
