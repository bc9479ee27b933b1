// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dReturns.h"

#include "Device/lms3dScanFieldData.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <numeric>

namespace
{
// Point data grows to this number of arrays at once. VTK would enlarge it for each array.
constexpr int UsualArrays = 8;
} // namespace

void lms3dReturns::FillVertices(vtkIdType first, vtkIdType last) const
{
  const vtkTypeInt32 start = static_cast<vtkTypeInt32>(first);
  vtkTypeInt32* offsets = this->VertexOffsets->GetPointer(0);
  vtkTypeInt32* points = this->VertexPoints->GetPointer(0);
  std::iota(offsets + first, offsets + last, start);
  std::iota(points + first, points + last, start);
}

void lms3dReturns::MoveTo(
  const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkPolyData* scan) const
{
  this->VertexOffsets->SetValue(this->Count, static_cast<vtkTypeInt32>(this->Count));
  vtkNew<vtkPoints> points;
  points->SetData(this->Points);
  scan->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(this->VertexOffsets, this->VertexPoints);
  scan->SetVerts(vertices);
  vtkPointData* pointData = scan->GetPointData();
  pointData->AllocateArrays(std::max(UsualArrays, pointData->GetNumberOfArrays()));
  pointData->SetScalars(this->Ranges);
  pointData->AddArray(this->Alphas);
  pointData->AddArray(this->Betas);
  pointData->AddArray(this->BeamIds);
  lms3dAddFieldData(geometry, pose, scan);
}
