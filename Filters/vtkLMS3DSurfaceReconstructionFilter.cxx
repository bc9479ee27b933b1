// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include "Device/lms3dScanInput.h"
#include "LocalMap/Bounded/lms3dBoundedMesher.h"
#include "LocalMap/Bounded/lms3dBoundedOutput.h"
#include "LocalMap/Grid/lms3dGridMap.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
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
// What of the whole work placing the returns takes, in the eyes of the progress bar.
constexpr double PlaceShare = 0.3;
} // namespace

struct vtkLMS3DSurfaceReconstructionFilter::Internals
{
  /// Tables of sines and cosines are made for new angles only.
  const lms3dScanGeometry& GetGeometry(const lms3dScanInput& scan)
  {
    if (!this->Geometry || !scan.HasAngles(*this->Geometry))
    {
      this->Geometry = std::make_unique<lms3dScanGeometry>(scan.GetGeometry());
    }
    return *this->Geometry;
  }

  lms3dThreads Threads;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
  lms3dGridMap Map;

private:
  std::unique_ptr<lms3dScanGeometry> Geometry;
};

vtkLMS3DSurfaceReconstructionFilter::vtkLMS3DSurfaceReconstructionFilter()
  : Internal(new Internals)
{
}

vtkLMS3DSurfaceReconstructionFilter::~vtkLMS3DSurfaceReconstructionFilter() = default;

int vtkLMS3DSurfaceReconstructionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
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
      this->CheckProperties();
      const lms3dScanInput scan(vtkPolyData::GetData(inputVector[0]));
      if (scan.GetNumberOfReturns() > 0)
      {
        this->Internal->Threads.Run(this->NumberOfThreads,
          [&] { this->MakeMap(scan, progress, vtkPolyData::GetData(outputVector)); });
      }
    },
    "There is not enough memory for the map. Scan with lower resolutions.");
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  if (isStopped)
  {
    lms3dClearOutputs(outputVector);
  }
  return 1;
}

void vtkLMS3DSurfaceReconstructionFilter::CheckProperties() const
{
  if (std::isnan(this->DepthStep))
  {
    throw std::runtime_error("DepthStep is not a number; 0 or more metres are expected.");
  }
  if (std::isnan(this->MaximumError))
  {
    throw std::runtime_error("MaximumError is not a number; 0 or more metres are expected.");
  }
}

void vtkLMS3DSurfaceReconstructionFilter::MakeMap(
  const lms3dScanInput& scan, const lms3dProgress& progress, vtkPolyData* map)
{
  scan.CheckPoints();
  lms3dRangeGrid& grid = this->Internal->Grid;
  grid.Place(this->Internal->GetGeometry(scan), scan.GetRanges(), scan.GetBeamIds(),
    scan.GetNumberOfReturns());
  this->Internal->Joins.Find(grid, this->DepthStep);
  if (!progress(PlaceShare))
  {
    return;
  }
  const auto progressOfRest = [&progress](double done)
  { return progress(PlaceShare + done * (1.0 - PlaceShare)); };
  if (this->MaximumError > 0.0)
  {
    lms3dBoundedMesher mesher(grid, this->Internal->Joins, this->MaximumError);
    if (const std::optional<lms3dBoundedMap> bounded = mesher.MakeMap(progressOfRest))
    {
      lms3dFillBoundedOutput(scan, *bounded, map);
    }
  }
  else
  {
    this->Internal->Map.Fill(scan, grid, this->Internal->Joins, progressOfRest, map);
  }
}

void vtkLMS3DSurfaceReconstructionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumError: " << this->MaximumError << '\n';
  os << indent << "DepthStep: " << this->DepthStep << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
}
