// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/lms3dRangeErrorJob.h"

#include "Device/lms3dRangeImage.h"
#include "Device/lms3dScanFieldData.h"
#include "Pipeline/lms3dPooledArray.h"
#include "RangeErrors/lms3dIdealGrid.h"
#include "RangeErrors/lms3dReportedScan.h"
#include "RangeErrors/lms3dReportedStatus.h"
#include "RangeErrors/lms3dSharedGrid.h"
#include "Scan/lms3dBeamStatus.h"
#include "Scan/lms3dProcesses.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace
{
// Shares of the progress bar.
constexpr double GridShare = 0.3;
constexpr double ErrorShare = 0.7;

// Returns the time of a scan, 0 if it has none.
double GetTime(vtkPolyData* scan)
{
  vtkInformation* info = scan->GetInformation();
  const auto time = vtkDataObject::DATA_TIME_STEP();
  return info->Has(time) ? info->Get(time) : 0.0;
}

void CheckAngles(const lms3dScanInput& scan, const lms3dScanGeometry& geometry)
{
  if (scan.GetNumberOfReturns() > 0 && !scan.HasAngles(geometry))
  {
    throw std::runtime_error(
      "The processes have returns of scans with different angles or "
      "platforms. Connect one scan, the first output of vtkLMS3DScanFilter.");
  }
}

void FillImage(const lms3dRangeErrorJobRequest& request, const lms3dProcesses& processes,
  const lms3dScanGeometry& geometry, vtkDoubleArray* grid)
{
  vtkImageData* image = vtkImageData::GetData(request.Outputs, 1);
  if (processes.IsParallel())
  {
    const int ghosts = request.Outputs->GetInformationObject(1)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    lms3dFillRangeImagePiece(
      geometry, grid->GetPointer(0), { processes.GetRank(), processes.GetCount(), ghosts }, image);
  }
  else
  {
    lms3dFillRangeImage(geometry, grid, image);
  }
}

void AddStatus(const lms3dRangeErrorJobRequest& request, const lms3dReportedStatus& status,
  const lms3dScanGeometry& geometry)
{
  const auto merged = status.Merge(
    request.Controller, geometry.CountBeamsOfAllTurns(), vtkPolyData::GetData(request.Outputs, 0));
  if (merged)
  {
    lms3dAddStatus(merged, geometry.GetNumberOfBeams(), vtkImageData::GetData(request.Outputs, 1));
  }
}
} // namespace

const lms3dScanGeometry* lms3dRangeErrorJob::GetGeometry(
  vtkPolyData* scan, vtkMultiProcessController* controller)
{
  lms3dGridAngles angles = lms3dShareAngles(lms3dGetGridAngles(scan->GetFieldData()), controller);
  if (angles.Alpha.empty())
  {
    return nullptr;
  }
  if (!this->Geometry || this->Geometry->GetAlphaAngles() != angles.Alpha ||
    this->Geometry->GetBetaAngles() != angles.Beta ||
    !(this->Geometry->GetPlatform() == angles.Platform))
  {
    this->Geometry = std::make_unique<lms3dScanGeometry>(
      std::move(angles.Alpha), std::move(angles.Beta), angles.Platform);
  }
  return this->Geometry.get();
}

bool lms3dRangeErrorJob::Run(const lms3dRangeErrorJobRequest& request)
{
  const lms3dProcesses processes(request.Controller);
  const lms3dScanGeometry* geometry = this->GetGeometry(request.Scan, request.Controller);
  vtkSmartPointer<vtkDoubleArray> grid;
  std::optional<lms3dReportedStatus> status;
  bool isStopped = false;
  processes.RunCollectively(
    [&]
    {
      const lms3dScanInput scan(request.Scan);
      if (geometry)
      {
        CheckAngles(scan, *geometry);
        const vtkIdType beams = geometry->CountBeamsOfAllTurns();
        grid = lms3dMakeArray<vtkDoubleArray>(this->Pool, "Range", beams);
        this->Threads.Run(request.NumberOfThreads,
          [&] { isStopped = !this->Report(request, scan, *geometry, grid->GetPointer(0)); });
        status.emplace(scan, request.Scan, grid->GetPointer(0), beams, request.Controller);
      }
    });
  if (processes.AnyOf(isStopped))
  {
    return false;
  }
  if (geometry && status)
  {
    lms3dMergeGrids(
      request.Controller, static_cast<std::size_t>(grid->GetNumberOfValues()), grid->GetPointer(0));
    FillImage(request, processes, *geometry, grid);
    AddStatus(request, *status, *geometry);
  }
  this->Pool.FreeUnused();
  return true;
}

bool lms3dRangeErrorJob::Report(const lms3dRangeErrorJobRequest& request,
  const lms3dScanInput& scan, const lms3dScanGeometry& geometry, double* grid)
{
  vtkPolyData* output = vtkPolyData::GetData(request.Outputs, 0);
  lms3dFillGrid(scan, geometry, grid);
  if (!request.Progress(GridShare))
  {
    return false;
  }
  if (request.Settings.AreOff() || scan.GetNumberOfReturns() == 0)
  {
    output->ShallowCopy(request.Scan);
    return true;
  }
  lms3dAddRangeErrors(request.Settings, lms3dGetScanNumber(GetTime(request.Scan)), geometry, grid);
  if (!request.Progress(ErrorShare))
  {
    return false;
  }
  lms3dFillReportedScan(scan, geometry, grid, this->Pool, request.Scan, output);
  return true;
}
