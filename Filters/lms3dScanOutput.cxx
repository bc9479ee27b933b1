// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dScanOutput.h"

#include "lms3dPacketKernels.h"
#include "lms3dPooledArray.h"
#include "lms3dProcesses.h"

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkExtentTranslator.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTypeInt32Array.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{
void AddDoubles(vtkFieldData* fieldData, const char* name, const double* values, vtkIdType count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(count);
  std::copy(values, values + count, array->GetPointer(0));
  fieldData->AddArray(array);
}

void AddFieldData(const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkFieldData* fieldData)
{
  const std::vector<double>& alpha = geometry.GetAlphaAngles();
  const std::vector<double>& beta = geometry.GetBetaAngles();
  std::array<double, 16> matrix{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = pose.Axes[column][row];
    }
    matrix[4 * row + 3] = pose.Position[row];
  }
  matrix[15] = 1.0;
  AddDoubles(fieldData, "AlphaAngles", alpha.data(), static_cast<vtkIdType>(alpha.size()));
  AddDoubles(fieldData, "BetaAngles", beta.data(), static_cast<vtkIdType>(beta.size()));
  AddDoubles(fieldData, "SensorToWorld", matrix.data(), static_cast<vtkIdType>(matrix.size()));
}

std::size_t CountBeams(const lms3dScanGeometry& geometry)
{
  return static_cast<std::size_t>(geometry.GetNumberOfBeams()) * geometry.GetNumberOfTurns();
}

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

// A step of 0 would make an image without area.
double GetSpacing(double step)
{
  return step > 0.0 ? step : 1.0;
}

/// One axis of the range image.
struct Axis
{
  double Start;
  double Step;
  int Count;
};

struct ImageFrame
{
  ImageFrame(const Axis& alpha, const Axis& beta)
    : Extent{ 0, alpha.Count - 1, 0, beta.Count - 1, 0, 0 }
    , Origin{ alpha.Start, beta.Start, 0.0 }
    , Spacing{ GetSpacing(alpha.Step), GetSpacing(beta.Step), 1.0 }
  {
  }

  int Extent[6];
  double Origin[3];
  double Spacing[3];
};

ImageFrame MakeFrame(const lms3dScanGeometry& geometry)
{
  return { { geometry.GetAlphaAngles().front(), geometry.GetAlphaStep(),
             geometry.GetNumberOfBeams() },
    { geometry.GetBetaAngles().front(), geometry.GetBetaStep(), geometry.GetNumberOfTurns() } };
}
} // namespace

void lms3dDescribeRangeImage(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, vtkInformation* info)
{
  const ImageFrame frame(
    { alphaRange[0], lms3dScanGeometry::GetStep(alphaRange, alphaResolution), alphaResolution },
    { betaRange[0], lms3dScanGeometry::GetStep(betaRange, betaResolution), betaResolution });
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), frame.Extent, 6);
  info->Set(vtkDataObject::ORIGIN(), frame.Origin, 3);
  info->Set(vtkDataObject::SPACING(), frame.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
}

/// Where the returns go: a slot for each in every array.
struct lms3dScanOutput::Returns
{
  Returns(lms3dMemoryPool& pool, vtkIdType count)
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

  void MoveTo(vtkPolyData* scan) const
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

  const vtkSmartPointer<vtkDoubleArray> Points;
  const vtkSmartPointer<vtkDoubleArray> Ranges;
  const vtkSmartPointer<vtkFloatArray> Alphas;
  const vtkSmartPointer<vtkFloatArray> Betas;
  const vtkSmartPointer<vtkIntArray> BeamIds;
  const vtkSmartPointer<vtkIdTypeArray> CellIds;
  const vtkSmartPointer<vtkTypeInt32Array> VertexOffsets;
  const vtkSmartPointer<vtkTypeInt32Array> VertexPoints;

  double* const Point;
  double* const Range;
  float* const Alpha;
  float* const Beta;
  int* const BeamId;
  vtkIdType* const CellId;
  vtkTypeInt32* const VertexOffset;
  vtkTypeInt32* const VertexPoint;
};

/// Fills the slots of one turn.
struct lms3dScanOutput::TurnSource
{
  void FillAll(std::size_t slot, const Returns& returns) const
  {
    const int count = this->Geometry.GetNumberOfBeams();
    this->Fill(count, slot, returns, [](int i) { return i; });
    this->Locate(count, slot, returns, this->Geometry.GetAlphaCosines().data(),
      this->Geometry.GetAlphaSines().data());
  }

  void FillSome(const std::vector<int>& hits, std::size_t slot, const Returns& returns) const
  {
    const int count = static_cast<int>(hits.size());
    this->Fill(count, slot, returns, [&hits](int i) { return hits[i]; });
    std::vector<double> cosines(count), sines(count);
    for (int i = 0; i < count; ++i)
    {
      cosines[i] = this->Geometry.GetAlphaCosine(hits[i]);
      sines[i] = this->Geometry.GetAlphaSine(hits[i]);
    }
    this->Locate(count, slot, returns, cosines.data(), sines.data());
  }

  // `beamOf` tells the beam of a return. One loop for each array keeps them simple enough to be
  // vectorized, where all beams of the turn returned at least.
  template <typename BeamOf>
  void Fill(int count, std::size_t slot, const Returns& returns, const BeamOf& beamOf) const
  {
    this->FillEach(returns.Range + slot, count, [&](int i) { return this->Ranges[beamOf(i)]; });
    const double* alpha = this->Geometry.GetAlphaAngles().data();
    this->FillEach(
      returns.Alpha + slot, count, [&](int i) { return static_cast<float>(alpha[beamOf(i)]); });
    this->FillEach(
      returns.BeamId + slot, count, [&](int i) { return this->FirstBeam + beamOf(i); });
    this->FillEach(returns.CellId + slot, count,
      [&](int i)
      {
        const int beam = beamOf(i);
        return this->Mesh ? this->Mesh->GetCell(this->Triangles[beam]) : this->Cells[beam];
      });
    std::fill_n(
      returns.Beta + slot, count, static_cast<float>(this->Geometry.GetBetaAngles()[this->Turn]));
    const vtkTypeInt32 first = static_cast<vtkTypeInt32>(slot);
    this->FillEach(returns.VertexOffset + slot, count, [&](int i) { return first + i; });
    this->FillEach(returns.VertexPoint + slot, count, [&](int i) { return first + i; });
  }

  void Locate(int count, std::size_t slot, const Returns& returns, const double* cosines,
    const double* sines) const
  {
    const lms3dReturnsOfTurn located = { cosines, sines, returns.Range + slot, count,
      this->Directions.GetFanAxis(this->Turn).data(), this->Directions.GetUp().data(),
      this->Position.data() };
    lms3dGetPacketKernels().Locate(located, returns.Point + 3 * slot);
  }

  template <typename T, typename ValueOf>
  static void FillEach(T* out, int count, const ValueOf& valueOf)
  {
    for (int i = 0; i < count; ++i)
    {
      out[i] = valueOf(i);
    }
  }

  const lms3dScanGeometry& Geometry;
  const lms3dBeamDirections& Directions;
  const std::array<double, 3>& Position;
  const lms3dTriangleMesh* const Mesh;
  const int Turn;
  const int FirstBeam;
  const double* Ranges;
  const std::int32_t* Triangles;
  const vtkIdType* Cells;
};

void lms3dScanOutput::Discard()
{
  this->Ranges = nullptr;
  this->Cells = {};
  this->Pool.FreeUnused();
}

void lms3dScanOutput::MakeRoom(std::size_t beams)
{
  this->Ranges = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Range", static_cast<vtkIdType>(beams));
  if (this->Triangles.capacity() > 2 * beams)
  {
    this->Triangles = {};
  }
  this->Triangles.resize(beams);
}

bool lms3dScanOutput::Cast(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress)
{
  this->MakeRoom(CountBeams(geometry));
  const lms3dBeamDirections directions(geometry, pose);
  return lms3dScan(caster, geometry, directions, pose, limits, progress,
    this->Ranges->GetPointer(0), this->Triangles.data());
}

bool lms3dScanOutput::CastPart(const lms3dRayCaster* caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress)
{
  const std::size_t beams = CountBeams(geometry);
  this->MakeRoom(beams);
  this->ChosenRanges.assign(beams, lms3dBeamPacket::NoRange);
  this->ChosenTriangles.assign(beams, lms3dBeamPacket::NoTriangle);
  if (!caster)
  {
    std::fill_n(this->Ranges->GetPointer(0), beams, NAN);
    return true;
  }
  const lms3dBeamDirections directions(geometry, pose);
  const lms3dChoices choices = { this->ChosenRanges.data(), this->ChosenTriangles.data() };
  return lms3dScan(*caster, geometry, directions, pose, limits, progress,
    this->Ranges->GetPointer(0), this->Triangles.data(), &choices);
}

void lms3dScanOutput::TakeNearest(
  const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell)
{
  const std::size_t beams = this->Triangles.size();
  this->Cells.resize(beams);
  for (std::size_t i = 0; i < beams; ++i)
  {
    const std::int32_t triangle = this->ChosenTriangles[i];
    this->Cells[i] = triangle == lms3dBeamPacket::NoTriangle
      ? lms3dProcesses::NoCell
      : firstCell + caster->GetMesh().GetCell(triangle);
  }
  double* ranges = this->Ranges->GetPointer(0);
  processes.TakeNearest(this->ChosenRanges, this->Cells, ranges);
  for (std::size_t i = 0; i < beams; ++i)
  {
    this->Triangles[i] = std::isnan(ranges[i]) ? lms3dBeamPacket::NoTriangle : 0;
  }
  this->ChosenRanges = {};
  this->ChosenTriangles = {};
}

/// For each turn the slot of its first return, and their number at the end.
std::vector<std::size_t> lms3dScanOutput::CountReturns(const lms3dScanGeometry& geometry) const
{
  const int beams = geometry.GetNumberOfBeams();
  std::vector<std::size_t> first(static_cast<std::size_t>(geometry.GetNumberOfTurns()) + 1, 0);
  tbb::parallel_for(0, geometry.GetNumberOfTurns(),
    [&](int turn)
    {
      const std::int32_t* triangle =
        this->Triangles.data() + static_cast<std::ptrdiff_t>(turn) * beams;
      // A count of the width of its elements is what compilers vectorize.
      std::int32_t hits = 0;
      for (int beam = 0; beam < beams; ++beam)
      {
        hits += triangle[beam] != lms3dBeamPacket::NoTriangle ? 1 : 0;
      }
      first[turn + 1] = static_cast<std::size_t>(hits);
    });
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

void lms3dScanOutput::FillTurn(int turn, std::size_t slot, const lms3dTriangleMesh* mesh,
  const lms3dScanGeometry& geometry, const lms3dBeamDirections& directions,
  const std::array<double, 3>& position, const Returns& returns) const
{
  const int beams = geometry.GetNumberOfBeams();
  const std::size_t firstBeam = static_cast<std::size_t>(turn) * beams;
  const TurnSource source = { geometry, directions, position, mesh, turn,
    static_cast<int>(firstBeam), this->Ranges->GetPointer(0) + firstBeam,
    this->Triangles.data() + firstBeam, mesh ? nullptr : this->Cells.data() + firstBeam };
  const std::vector<int> hits = GetHits(source.Triangles, beams);
  if (static_cast<int>(hits.size()) == beams)
  {
    source.FillAll(slot, returns);
  }
  else
  {
    source.FillSome(hits, slot, returns);
  }
}

void lms3dScanOutput::FillScan(const lms3dTriangleMesh* mesh, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, vtkPolyData* scan)
{
  const std::vector<std::size_t> first = this->CountReturns(geometry);
  const vtkIdType count = static_cast<vtkIdType>(first.back());
  const Returns returns(this->Pool, count);
  const lms3dBeamDirections directions(geometry, pose);
  tbb::parallel_for(0, geometry.GetNumberOfTurns(),
    [&](int turn)
    {
      if (first[turn] < first[turn + 1])
      {
        this->FillTurn(turn, first[turn], mesh, geometry, directions, pose.Position, returns);
      }
    });
  returns.VertexOffset[count] = static_cast<vtkTypeInt32>(count);
  returns.MoveTo(scan);
  AddFieldData(geometry, pose, scan->GetFieldData());
  this->Pool.FreeUnused();
}

void lms3dScanOutput::FillRangeImage(const lms3dScanGeometry& geometry, vtkImageData* image)
{
  ImageFrame frame = MakeFrame(geometry);
  image->SetExtent(frame.Extent);
  image->SetOrigin(frame.Origin);
  image->SetSpacing(frame.Spacing);
  image->GetPointData()->SetScalars(this->Ranges);
  this->Ranges = nullptr;
}

void lms3dScanOutput::FillRangeImagePart(const lms3dScanGeometry& geometry,
  const lms3dProcesses& processes, int ghostLevels, vtkImageData* image)
{
  ImageFrame frame = MakeFrame(geometry);
  int part[6];
  vtkNew<vtkExtentTranslator> translator;
  if (!translator->PieceToExtentThreadSafe(processes.GetRank(), processes.GetCount(), ghostLevels,
        frame.Extent, part, vtkExtentTranslator::BLOCK_MODE, 0))
  {
    return;
  }
  image->SetExtent(part);
  image->SetOrigin(frame.Origin);
  image->SetSpacing(frame.Spacing);
  image->AllocateScalars(VTK_DOUBLE, 1);
  double* out = static_cast<double*>(image->GetScalarPointer());
  const int beams = geometry.GetNumberOfBeams();
  for (int turn = part[2]; turn <= part[3]; ++turn)
  {
    const double* row = this->Ranges->GetPointer(static_cast<vtkIdType>(turn) * beams);
    out = std::copy(row + part[0], row + part[1] + 1, out);
  }
  image->GetPointData()->GetScalars()->SetName("Range");
}
