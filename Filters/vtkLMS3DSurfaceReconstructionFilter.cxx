// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include "Device/lms3dScanInput.h"
#include "LocalMap/Bounded/lms3dBoundedOutput.h"
#include "LocalMap/Bounded/lms3dGapMapper.h"
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
#include "Scan/lms3dFreeBeams.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkLMS3DSurfaceReconstructionFilter);

namespace
{
// The share of the time, for the progress bar, that building the grid takes, and that finding the
// joins of the plain grid takes as well.
constexpr double GridShare = 0.2;
constexpr double JoinsShare = 0.3;
// The largest gap that is closed if the scan says why beams have no returns.
constexpr int GapSizeWithStatus = 25;

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
  /// Fills an empty map. The scan must have returns. Lengths are metres. Uses the threads of the
  /// calling TBB arena. `isFree` is that of lms3dSurfaceGaps.
  void MakeMap(const lms3dScanInput& scan, const lms3dGapSettings& settings, bool keepsSpeckles,
    const std::vector<bool>& isFree, const lms3dProgress& progress, vtkPolyData* map);

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
  const lms3dGapSettings& settings, bool keepsSpeckles, const std::vector<bool>& isFree,
  const lms3dProgress& progress, vtkPolyData* map)
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
  const bool isBounded = settings.MaximumError > 0.0;
  if (!isBounded)
  {
    this->Joins.Find(this->Grid, settings.DepthStep, &geometry);
  }
  const double share = isBounded ? GridShare : JoinsShare;
  if (!progress(share))
  {
    return;
  }
  const auto progressOfRest = [&progress, share](double done)
  { return progress(share + done * (1.0 - share)); };
  if (!isBounded)
  {
    this->GridMap.Fill(mapScan, this->Grid, this->Joins, progressOfRest, map);
    return;
  }
  lms3dGapMapper mapper(mapScan, this->Grid, this->Joins, settings, keepsSpeckles, isFree);
  if (const std::optional<lms3dBoundedMap> bounded = mapper.MakeMap(progressOfRest))
  {
    lms3dFillBoundedOutput(mapScan, *bounded, map);
    mapper.FillOutput(*bounded, map);
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
      vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
      const lms3dScanInput scan(input);
      if (scan.GetNumberOfReturns() > 0)
      {
        const bool usesStatus = this->MaximumGapSize != 0 || this->MaximumSpeckleSize > 0;
        const std::vector<bool> isFree = usesStatus
          ? lms3dFindFreeBeams(input, scan.GetGeometry().CountBeamsOfAllTurns())
          : std::vector<bool>();
        const int automatic = isFree.empty() ? 0 : GapSizeWithStatus;
        const lms3dGapSettings settings = { this->MaximumGapSize < 0 ? automatic
                                                                     : this->MaximumGapSize,
          this->MaximumSpeckleSize, this->MaximumError, this->DepthStep };
        this->Internal->Threads.Run(this->NumberOfThreads,
          [&]
          {
            this->Internal->MakeMap(scan, settings, this->KeepSpeckles, isFree, progress,
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
  os << indent << "MaximumGapSize: " << this->MaximumGapSize << '\n';
  os << indent << "MaximumSpeckleSize: " << this->MaximumSpeckleSize << '\n';
  os << indent << "KeepSpeckles: " << this->KeepSpeckles << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
}
