// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dReportedScan.h"

#include "Device/lms3dBeams.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dPooledArray.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace
{
// The smallest part of a loop over returns that a thread takes.
constexpr vtkIdType MinimumGrainSize = 4096;

using Indices = tbb::blocked_range<vtkIdType>;

/// Sets ranges and points of returns from the grid of ranges.
class Placement
{
public:
  Placement(const lms3dScanInput& scan, const lms3dScanGeometry& geometry, const double* grid,
    double* ranges, double* points)
    : Ids(scan.GetBeamIds())
    , Geometry(geometry)
    , Pose(scan.GetPose())
    , Directions(geometry, this->Pose)
    , Beams(geometry, this->Pose)
    , Grid(grid)
    , Ranges(ranges)
    , Points(points)
  {
  }

  void Place(const Indices& part) const
  {
    for (vtkIdType first = part.begin(); first < part.end();)
    {
      const vtkIdType last = this->FindEndOfRun(first, part.end());
      this->PlaceRun(first, last);
      first = last;
    }
  }

private:
  // A run has consecutive beams of one turn.
  vtkIdType FindEndOfRun(vtkIdType first, vtkIdType last) const
  {
    const int beams = this->Geometry.GetNumberOfBeams();
    const int remaining = beams - this->Ids[first] % beams;
    last = std::min<vtkIdType>(last, first + remaining);
    vtkIdType i = first + 1;
    while (i < last && this->Ids[i] == this->Ids[i - 1] + 1)
    {
      ++i;
    }
    return i;
  }

  void PlaceRun(vtkIdType first, vtkIdType last) const
  {
    const int id = this->Ids[first];
    const int turn = id / this->Geometry.GetNumberOfBeams();
    const int beam = id % this->Geometry.GetNumberOfBeams();
    const vtkIdType count = last - first;
    std::copy_n(this->Grid + id, count, this->Ranges + first);
    if (!this->Geometry.GetPlatform().IsCentredAndStepped())
    {
      this->PlaceOffAxis(first, last, turn, beam);
      return;
    }
    const lms3dReturnsOfTurn run = { this->Geometry.GetAlphaCosines().data() + beam,
      this->Geometry.GetAlphaSines().data() + beam, this->Ranges + first, static_cast<int>(count),
      this->Directions.GetFanAxis(turn).data(), this->Directions.GetUp().data(),
      this->Pose.Position.data() };
    lms3dGetPacketKernels().Locate(run, this->Points + 3 * first);
  }

  // Places a run whose beams start beside the axis, or at different platform angles.
  void PlaceOffAxis(vtkIdType first, vtkIdType last, int turn, int beam) const
  {
    for (vtkIdType i = first; i < last; ++i, ++beam)
    {
      const lms3dVector point = lms3dAdd(this->Beams.GetOrigin(turn, beam),
        lms3dScale(this->Beams.GetDirection(turn, beam), this->Ranges[i]));
      std::copy(point.begin(), point.end(), this->Points + 3 * i);
    }
  }

  const int* const Ids;
  const lms3dScanGeometry& Geometry;
  const lms3dPose Pose;
  const lms3dBeamDirections Directions;
  const lms3dBeams Beams;
  const double* const Grid;
  double* const Ranges;
  double* const Points;
};

// Compilers vectorize a count, and do not vectorize a loop that stops early.
std::int64_t CountMissing(const double* ranges, vtkIdType count)
{
  std::int64_t missing = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    missing += std::isnan(ranges[i]) ? 1 : 0;
  }
  return missing;
}

// Single precision stays single precision.
vtkSmartPointer<vtkDataArray> KeepType(vtkDoubleArray* values, vtkDataArray* original)
{
  if (original->GetDataType() != VTK_FLOAT)
  {
    return values;
  }
  const auto copy = vtkSmartPointer<vtkFloatArray>::New();
  copy->DeepCopy(values);
  return copy;
}

// Keeps the returns whose range is not NaN, each with a vertex.
void KeepReturns(const double* ranges, vtkPolyData* scan)
{
  vtkNew<vtkIdList> kept;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    if (!std::isnan(ranges[i]))
    {
      kept->InsertNextId(i);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(scan->GetPoints()->GetDataType());
  scan->GetPoints()->GetPoints(kept, points);
  vtkNew<vtkPolyData> all;
  all->ShallowCopy(scan);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  scan->Initialize();
  scan->SetFieldData(all->GetFieldData());
  scan->SetPoints(points);
  scan->SetVerts(vertices);
  scan->GetPointData()->CopyAllOn();
  scan->GetPointData()->CopyAllocate(all->GetPointData(), kept->GetNumberOfIds());
  scan->GetPointData()->CopyData(all->GetPointData(), kept);
}
} // namespace

void lms3dFillReportedScan(const lms3dScanInput& scan, const lms3dScanGeometry& geometry,
  const double* grid, lms3dMemoryPool& pool, vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType count = scan.GetNumberOfReturns();
  const auto points = lms3dMakeArray<vtkDoubleArray>(pool, "Points", count, 3);
  const auto ranges = lms3dMakeArray<vtkDoubleArray>(pool, "Range", count);
  const Placement placement(scan, geometry, grid, ranges->GetPointer(0), points->GetPointer(0));
  tbb::parallel_for(Indices(0, count, MinimumGrainSize),
    [&placement](const Indices& part) { placement.Place(part); });

  output->ShallowCopy(input);
  vtkNew<vtkPoints> placed;
  placed->SetData(KeepType(points, input->GetPoints()->GetData()));
  output->SetPoints(placed);
  output->GetPointData()->AddArray(KeepType(ranges, input->GetPointData()->GetArray("Range")));

  if (CountMissing(ranges->GetPointer(0), count) > 0)
  {
    KeepReturns(ranges->GetPointer(0), output);
  }
}
