// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include "Device/lms3dScanInput.h"
#include "LocalMap/Bounded/lms3dBoundedMesher.h"
#include "LocalMap/Bounded/lms3dBoundedOutput.h"
#include "LocalMap/Grid/lms3dGridMap.h"
#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Grid/lms3dMapScan.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dErrorReport.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Pipeline/lms3dThreads.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkLMS3DSurfaceReconstructionFilter);

namespace
{
// The share of the time, for the progress bar, that building the grid takes.
constexpr double GridShare = 0.3;

void CheckLength(const char* name, double value)
{
  if (std::isnan(value))
  {
    throw std::runtime_error(
      std::string(name) + " is not a number; 0 or more metres are expected.");
  }
}
} // namespace

/// Keeps memory and tables from run to run.
struct vtkLMS3DSurfaceReconstructionFilter::Internals
{
  /// Fills an empty map. The scan must have returns. Lengths are metres. Uses the threads of the calling
  /// TBB arena.
  void MakeMap(const lms3dScanInput& scan, double maximumError, double depthStep,
    const lms3dProgress& progress, vtkPolyData* map);

  lms3dThreads Threads;
  lms3dErrorReport Errors;

private:
  /// Makes tables of sines and cosines for new angles only.
  const lms3dMapGeometry& GetGeometry(const lms3dScanInput& scan)
  {
    if (!this->Geometry || !scan.HasAngles(this->Geometry->GetScanned()))
    {
      this->Geometry = std::make_unique<lms3dMapGeometry>(scan.GetGeometry());
    }
    return *this->Geometry;
  }

  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
  lms3dGridMap GridMap;
  std::unique_ptr<lms3dMapGeometry> Geometry;
};

void vtkLMS3DSurfaceReconstructionFilter::Internals::MakeMap(const lms3dScanInput& scan,
  double maximumError, double depthStep, const lms3dProgress& progress, vtkPolyData* map)
{
  scan.CheckPoints();
  const lms3dMapGeometry& geometry = this->GetGeometry(scan);
  const lms3dMapScan mapScan(scan, geometry);
  if (mapScan.GetNumberOfReturns() == 0)
  {
    return;
  }
  this->Grid.Build(
    geometry.GetGrid(), mapScan.GetRanges(), mapScan.GetBeamIds(), mapScan.GetNumberOfReturns());
  this->Joins.Find(this->Grid, depthStep, &geometry);
  if (!progress(GridShare))
  {
    return;
  }
  const auto progressOfRest = [&progress](double done)
  { return progress(GridShare + done * (1.0 - GridShare)); };
  if (maximumError > 0.0)
  {
    lms3dBoundedMesher mesher(this->Grid, this->Joins, maximumError, &geometry);
    if (const std::optional<lms3dBoundedMap> bounded = mesher.MakeMap(progressOfRest))
    {
      lms3dFillBoundedOutput(mapScan, *bounded, map);
    }
  }
  else
  {
    this->GridMap.Fill(mapScan, this->Grid, this->Joins, progressOfRest, map);
  }
}

vtkLMS3DSurfaceReconstructionFilter::vtkLMS3DSurfaceReconstructionFilter()
  : Internal(new Internals)
{
}

vtkLMS3DSurfaceReconstructionFilter::~vtkLMS3DSurfaceReconstructionFilter() = default;

int vtkLMS3DSurfaceReconstructionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the filter, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  bool isStopped = false;
  const lms3dProgress report = lms3dReportTo(this, 0.0, 1.0);
  const auto progress = [&report, &isStopped](double done)
  {
    isStopped = !report(done) || isStopped;
    return !isStopped;
  };
  const std::string failure = lms3dRunAndGetError(
    [&]
    {
      CheckLength("DepthStep", this->DepthStep);
      CheckLength("MaximumError", this->MaximumError);
      const lms3dScanInput scan(vtkPolyData::GetData(inputVector[0]));
      if (scan.GetNumberOfReturns() > 0)
      {
        this->Internal->Threads.Run(this->NumberOfThreads,
          [&]
          {
            this->Internal->MakeMap(scan, this->MaximumError, this->DepthStep, progress,
              vtkPolyData::GetData(outputVector));
          });
      }
    },
    "There is not enough memory for the map. Choose lower resolutions for the scan.");
  if (!failure.empty())
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return this->Internal->Errors.Report(this, failure, outputVector);
  }
  if (isStopped)
  {
    lms3dClearOutputs(outputVector);
  }
  return 1;
}

void vtkLMS3DSurfaceReconstructionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumError: " << this->MaximumError << '\n';
  os << indent << "DepthStep: " << this->DepthStep << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
}
