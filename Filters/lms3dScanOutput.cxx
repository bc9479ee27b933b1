// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dScanOutput.h"

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace
{
template <typename ArrayT>
typename ArrayT::ValueType* Allocate(ArrayT* array, const char* name, vtkIdType count)
{
  array->SetName(name);
  array->SetNumberOfValues(count);
  return array->GetPointer(0);
}

void AddDoubles(vtkFieldData* fieldData, const char* name, const double* values, vtkIdType count)
{
  vtkNew<vtkDoubleArray> array;
  std::copy(values, values + count, Allocate(array.Get(), name, count));
  fieldData->AddArray(array);
}

// A step of 0 would make an image without area.
double GetSpacing(double step)
{
  return step > 0.0 ? step : 1.0;
}

struct ImageFrame
{
  explicit ImageFrame(const lms3dScanGeometry& geometry)
    : Extent{ 0, geometry.GetNumberOfBeams() - 1, 0, geometry.GetNumberOfTurns() - 1, 0, 0 }
    , Origin{ geometry.GetAlphaAngles().front(), geometry.GetBetaAngles().front(), 0.0 }
    , Spacing{ GetSpacing(geometry.GetAlphaStep()), GetSpacing(geometry.GetBetaStep()), 1.0 }
  {
  }

  int Extent[6];
  double Origin[3];
  double Spacing[3];
};
} // namespace

void lms3dDescribeRangeImage(const lms3dScanGeometry& geometry, vtkInformation* info)
{
  const ImageFrame frame(geometry);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), frame.Extent, 6);
  info->Set(vtkDataObject::ORIGIN(), frame.Origin, 3);
  info->Set(vtkDataObject::SPACING(), frame.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
}

/// Arrays with a slot for each return, and where the slots of each turn begin.
struct lms3dScanOutput::Returns
{
  std::vector<std::size_t> FirstOfTurn;
  double* Point;
  double* Range;
  float* Alpha;
  float* Beta;
  int* BeamId;
  vtkIdType* CellId;
};

lms3dScanOutput::lms3dScanOutput(const lms3dScanGeometry& geometry, const lms3dPose& pose)
  : Geometry(geometry)
  , Pose(pose)
{
  const vtkIdType beams =
    static_cast<vtkIdType>(geometry.GetNumberOfBeams()) * geometry.GetNumberOfTurns();
  Allocate(this->Ranges.Get(), "Range", beams);
  this->Triangles.resize(beams);
}

bool lms3dScanOutput::Cast(
  const lms3dRayCaster& caster, const lms3dRangeLimits& limits, const lms3dProgress& progress)
{
  return lms3dScan(caster, this->Geometry, this->Pose, limits, progress,
    this->Ranges->GetPointer(0), this->Triangles.data());
}

lms3dScanOutput::Returns lms3dScanOutput::CountReturns() const
{
  const int beams = this->Geometry.GetNumberOfBeams();
  const int turns = this->Geometry.GetNumberOfTurns();
  Returns returns{};
  returns.FirstOfTurn.assign(turns + 1, 0);
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      const auto first = this->Triangles.begin() + static_cast<std::ptrdiff_t>(turn) * beams;
      returns.FirstOfTurn[turn + 1] =
        beams - std::count(first, first + beams, lms3dBeamPacket::NoTriangle);
    });
  std::partial_sum(
    returns.FirstOfTurn.begin(), returns.FirstOfTurn.end(), returns.FirstOfTurn.begin());
  return returns;
}

void lms3dScanOutput::FillTurn(int turn, std::size_t slot, const lms3dRayCaster& caster,
  const lms3dScanGeometry::Directions& directions, const Returns& returns) const
{
  const int beams = this->Geometry.GetNumberOfBeams();
  const std::size_t firstBeam = static_cast<std::size_t>(turn) * beams;
  for (int beam = 0; beam < beams; ++beam)
  {
    const std::int32_t triangle = this->Triangles[firstBeam + beam];
    if (triangle == lms3dBeamPacket::NoTriangle)
    {
      continue;
    }
    const double range = this->Ranges->GetPointer(0)[firstBeam + beam];
    const std::array<double, 3> direction = directions.GetDirection(turn, beam);
    for (int axis = 0; axis < 3; ++axis)
    {
      returns.Point[3 * slot + axis] = this->Pose.Position[axis] + range * direction[axis];
    }
    returns.Range[slot] = range;
    returns.Alpha[slot] = static_cast<float>(this->Geometry.GetAlphaAngles()[beam]);
    returns.Beta[slot] = static_cast<float>(this->Geometry.GetBetaAngles()[turn]);
    returns.BeamId[slot] = static_cast<int>(firstBeam) + beam;
    returns.CellId[slot] = caster.GetMesh().Cells[triangle];
    ++slot;
  }
}

void lms3dScanOutput::FillScan(const lms3dRayCaster& caster, vtkPolyData* scan) const
{
  Returns returns = this->CountReturns();
  const vtkIdType count = static_cast<vtkIdType>(returns.FirstOfTurn.back());

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  returns.Point = Allocate(coordinates.Get(), "Points", 3 * count);
  vtkNew<vtkDoubleArray> range;
  returns.Range = Allocate(range.Get(), "Range", count);
  vtkNew<vtkFloatArray> alpha;
  returns.Alpha = Allocate(alpha.Get(), "Alpha", count);
  vtkNew<vtkFloatArray> beta;
  returns.Beta = Allocate(beta.Get(), "Beta", count);
  vtkNew<vtkIntArray> beamId;
  returns.BeamId = Allocate(beamId.Get(), "BeamId", count);
  vtkNew<vtkIdTypeArray> cellId;
  returns.CellId = Allocate(cellId.Get(), "CellId", count);

  const lms3dScanGeometry::Directions directions(this->Geometry, this->Pose);
  tbb::parallel_for(0, this->Geometry.GetNumberOfTurns(),
    [&](int turn)
    { this->FillTurn(turn, returns.FirstOfTurn[turn], caster, directions, returns); });

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  scan->SetPoints(points);

  vtkNew<vtkIdTypeArray> offsets;
  vtkIdType* offset = Allocate(offsets.Get(), "Offsets", count + 1);
  std::iota(offset, offset + count + 1, 0);
  vtkNew<vtkIdTypeArray> connectivity;
  vtkIdType* vertex = Allocate(connectivity.Get(), "Connectivity", count);
  std::iota(vertex, vertex + count, 0);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, connectivity);
  scan->SetVerts(vertices);

  vtkPointData* pointData = scan->GetPointData();
  pointData->SetScalars(range);
  pointData->AddArray(alpha);
  pointData->AddArray(beta);
  pointData->AddArray(beamId);
  pointData->AddArray(cellId);
  this->AddFieldData(scan);
}

void lms3dScanOutput::AddFieldData(vtkPolyData* scan) const
{
  const std::vector<double>& alpha = this->Geometry.GetAlphaAngles();
  const std::vector<double>& beta = this->Geometry.GetBetaAngles();
  std::array<double, 16> matrix{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = this->Pose.Axes[column][row];
    }
    matrix[4 * row + 3] = this->Pose.Position[row];
  }
  matrix[15] = 1.0;

  vtkFieldData* fieldData = scan->GetFieldData();
  AddDoubles(fieldData, "AlphaAngles", alpha.data(), static_cast<vtkIdType>(alpha.size()));
  AddDoubles(fieldData, "BetaAngles", beta.data(), static_cast<vtkIdType>(beta.size()));
  AddDoubles(fieldData, "SensorToWorld", matrix.data(), static_cast<vtkIdType>(matrix.size()));
}

void lms3dScanOutput::FillRangeImage(vtkImageData* image) const
{
  ImageFrame frame(this->Geometry);
  image->SetExtent(frame.Extent);
  image->SetOrigin(frame.Origin);
  image->SetSpacing(frame.Spacing);
  image->GetPointData()->SetScalars(this->Ranges.Get());
}
