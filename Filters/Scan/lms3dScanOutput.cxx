// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanOutput.h"

#include "Device/lms3dBeams.h"
#include "Device/lms3dReturns.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dPooledArray.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dRayScanner.h"
#include "Scan/lms3dTurnReturns.h"

#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace
{
// Beams whose returns are filled together: enough for long streams of memory, few enough to share
// the work among threads.
constexpr int BeamsToFill = 8192;

// Both outputs need name and information of their own, since their users can change them.
vtkSmartPointer<vtkDoubleArray> MakeTwin(vtkDoubleArray* array)
{
  auto twin = vtkSmartPointer<vtkDoubleArray>::New();
  twin->ShallowCopy(array);
  return twin;
}
} // namespace

void lms3dScanOutput::Discard()
{
  this->DiscardPlan();
  this->Ranges = nullptr;
  this->Part = {};
  this->Pool.FreeUnused();
}

void lms3dScanOutput::Allocate(std::size_t beams)
{
  this->Ranges = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Range", static_cast<vtkIdType>(beams));
  if (this->Triangles.capacity() > 2 * beams)
  {
    this->Triangles = {};
  }
  this->Triangles.resize(beams);
  this->Part = {};
}

void lms3dScanOutput::AllocatePart(std::size_t beams)
{
  this->Allocate(beams);
  this->Part.Allocate(beams);
}

void lms3dScanOutput::MakePlan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, double maximumRange)
{
  if (!this->Plan || !this->Plan->Fits(caster, geometry, pose, maximumRange))
  {
    this->Plan.emplace(caster, geometry, pose, maximumRange);
  }
}

bool lms3dScanOutput::Cast(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress)
{
  this->Allocate(static_cast<std::size_t>(geometry.CountBeamsOfAllTurns()));
  const bool isPlanned = this->Plan && this->Plan->Fits(caster, geometry, pose, limits.Maximum);
  return lms3dScan(
    { caster, geometry, pose, limits, { this->Ranges->GetPointer(0), this->Triangles.data() },
      { nullptr, nullptr }, isPlanned ? &*this->Plan : nullptr },
    progress);
}

bool lms3dScanOutput::CastPart(const lms3dRayCaster* caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress)
{
  this->AllocatePart(static_cast<std::size_t>(geometry.CountBeamsOfAllTurns()));
  if (!caster)
  {
    this->SetNoReturn();
    return true;
  }
  return lms3dScan(
    { *caster, geometry, pose, limits, { this->Ranges->GetPointer(0), this->Triangles.data() },
      this->Part.GetNearest() },
    progress);
}

bool lms3dScanOutput::CastRays(const lms3dRayCaster* caster, const lms3dMovingBeams& beams,
  const lms3dRangeLimits& limits, bool isPart, const lms3dProgress& progress)
{
  const lms3dScanGeometry& geometry = beams.GetGeometry();
  const lms3dMixedBeams hits = this->AllocateMixed(geometry.CountBeamsOfAllTurns(), isPart);
  if (!caster)
  {
    this->SetNoReturn();
    return true;
  }
  const std::vector<lms3dRayFan> fans(1, lms3dRayFan(beams.GetFan()));
  return lms3dScanRays({ *caster, beams, fans, limits, 0, geometry.GetNumberOfTurns(), hits.Returns,
                         this->Part.GetNearest() },
    progress);
}

lms3dMixedBeams lms3dScanOutput::AllocateMixed(std::int64_t beams, bool isPart)
{
  if (isPart)
  {
    this->AllocatePart(static_cast<std::size_t>(beams));
  }
  else
  {
    this->Allocate(static_cast<std::size_t>(beams));
  }
  return { { this->Ranges->GetPointer(0), this->Triangles.data() },
    isPart ? this->Part.Triangles.data() : nullptr, isPart ? this->Part.Cells.data() : nullptr };
}

void lms3dScanOutput::SetNoReturn()
{
  std::fill_n(this->Ranges->GetPointer(0), this->Triangles.size(), NAN);
}

void lms3dScanOutput::ReduceToNearest(
  const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell)
{
  this->Part.ReduceToNearest(
    processes, caster, firstCell, this->Ranges->GetPointer(0), this->Triangles.data());
}

void lms3dScanOutput::CopyRanges(vtkDoubleArray* ranges) const
{
  ranges->SetNumberOfValues(this->Ranges->GetNumberOfValues());
  std::copy_n(this->GetRanges(), this->Ranges->GetNumberOfValues(), ranges->GetPointer(0));
  ranges->Modified();
}

bool lms3dScanOutput::HasMissingReturns() const
{
  return std::any_of(this->Triangles.begin(), this->Triangles.end(),
    [](std::int32_t triangle) { return triangle == lms3dBeamPacket::NoTriangle; });
}

void lms3dScanOutput::RemoveReturns(const std::vector<unsigned char>& isRemoved)
{
  double* ranges = this->Ranges->GetPointer(0);
  for (std::size_t i = 0; i < isRemoved.size(); ++i)
  {
    ranges[i] = isRemoved[i] ? NAN : ranges[i];
    this->Triangles[i] = isRemoved[i] ? lms3dBeamPacket::NoTriangle : this->Triangles[i];
  }
  for (std::size_t i = 0; i < this->Part.Triangles.size(); ++i)
  {
    this->Part.Triangles[i] = isRemoved[i] ? lms3dBeamPacket::NoTriangle : this->Part.Triangles[i];
  }
}

std::vector<std::size_t> lms3dScanOutput::CountReturns(const lms3dScanGeometry& geometry) const
{
  const int beams = geometry.GetNumberOfBeams();
  std::vector<std::size_t> first(static_cast<std::size_t>(geometry.GetNumberOfTurns()) + 1, 0);
  const lms3dReturnKernels& kernels = lms3dGetPacketKernels().Returns;
  tbb::parallel_for(0, geometry.GetNumberOfTurns(),
    [&](int turn)
    {
      const std::int32_t* triangles =
        this->Triangles.data() + static_cast<std::ptrdiff_t>(turn) * beams;
      first[turn + 1] = static_cast<std::size_t>(kernels.CountReturns(triangles, beams));
    });
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

void lms3dScanOutput::Fill(const lms3dTriangleMesh* mesh, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, vtkPolyData* scan, vtkImageData* image)
{
  const std::vector<std::size_t> first = this->CountReturns(geometry);
  const vtkIdType count = static_cast<vtkIdType>(first.back());
  const lms3dReturns returns = count == this->Ranges->GetNumberOfValues()
    ? lms3dReturns(MakeTwin(this->Ranges), this->Pool)
    : lms3dReturns(count, this->Pool);
  const auto cellIds = lms3dMakeArray<vtkIdTypeArray>(this->Pool, "CellId", count);
  vtkIdType* cellId = cellIds->GetPointer(0);
  const lms3dBeamDirections directions(geometry, pose);
  const std::unique_ptr<const lms3dBeams> beams = geometry.GetPlatform().IsCentredAndStepped()
    ? nullptr
    : std::make_unique<lms3dBeams>(geometry, pose);
  const lms3dTurnReturns source = { geometry, directions, beams.get(), pose.Position,
    this->Ranges->GetPointer(0), this->Triangles.data(), mesh, this->Part.Cells.data() };
  const int turns = geometry.GetNumberOfTurns();
  const int grain = std::max(1, BeamsToFill / geometry.GetNumberOfBeams());
  // The other threads fill the arrays while this one adds them to the outputs. They begin at the
  // end, since they cast the last turns and have these in their caches.
  tbb::task_group filling;
  filling.run(
    [&]
    {
      tbb::parallel_for(tbb::blocked_range<int>(0, turns, grain),
        [&](const tbb::blocked_range<int>& range)
        { source.Fill(turns - range.end(), turns - range.begin(), first, returns, cellId); });
    });
  returns.MoveTo(geometry, pose, scan);
  scan->GetPointData()->AddArray(cellIds);
  if (image)
  {
    lms3dFillRangeImage(geometry, this->Ranges, image);
  }
  filling.wait();
  this->Pool.FreeUnused();
}

void lms3dScanOutput::FillRangeImagePiece(
  const lms3dScanGeometry& geometry, const lms3dImagePiece& piece, vtkImageData* image) const
{
  lms3dFillRangeImagePiece(geometry, this->Ranges->GetPointer(0), piece, image);
}
