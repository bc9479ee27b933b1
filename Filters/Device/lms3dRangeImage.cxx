// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dRangeImage.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkExtentTranslator.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cstddef>

namespace
{
// A spacing of 0 would make an image without area.
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

void Describe(const ImageFrame& frame, vtkInformation* info)
{
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), frame.Extent, 6);
  info->Set(vtkDataObject::ORIGIN(), frame.Origin, 3);
  info->Set(vtkDataObject::SPACING(), frame.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
}
} // namespace

void lms3dDescribeRangeImage(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, vtkInformationVector* outputs)
{
  const ImageFrame frame(
    { alphaRange[0], lms3dScanGeometry::GetStep(alphaRange, alphaResolution), alphaResolution },
    { betaRange[0], lms3dScanGeometry::GetStep(betaRange, betaResolution), betaResolution });
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    Describe(frame, outputs->GetInformationObject(port));
  }
}

void lms3dDescribeRangeImage(const lms3dScanGeometry& geometry, vtkInformation* info)
{
  Describe(MakeFrame(geometry), info);
}

void lms3dFillRangeImage(
  const lms3dScanGeometry& geometry, vtkDoubleArray* ranges, vtkImageData* image)
{
  ImageFrame frame = MakeFrame(geometry);
  image->SetExtent(frame.Extent);
  image->SetOrigin(frame.Origin);
  image->SetSpacing(frame.Spacing);
  image->GetPointData()->SetScalars(ranges);
}

void lms3dFillRangeImagePiece(const lms3dScanGeometry& geometry, const double* ranges,
  const lms3dImagePiece& piece, vtkImageData* image)
{
  ImageFrame frame = MakeFrame(geometry);
  int part[6];
  vtkNew<vtkExtentTranslator> translator;
  if (!translator->PieceToExtentThreadSafe(piece.Number, piece.Count, piece.GhostLevels,
        frame.Extent, part, vtkExtentTranslator::BLOCK_MODE, 0))
  {
    return;
  }
  image->SetExtent(part);
  image->SetOrigin(frame.Origin);
  image->SetSpacing(frame.Spacing);
  image->AllocateScalars(VTK_DOUBLE, 1);
  double* out = static_cast<double*>(image->GetScalarPointer());
  const std::ptrdiff_t beams = geometry.GetNumberOfBeams();
  for (int turn = part[2]; turn <= part[3]; ++turn)
  {
    const double* row = ranges + turn * beams;
    out = std::copy(row + part[0], row + part[1] + 1, out);
  }
  image->GetPointData()->GetScalars()->SetName("Range");
}
