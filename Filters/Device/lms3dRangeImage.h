// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The range image of a scan: ranges in metres, NaN without a return; elevations along x,
 * turns along y, both in degrees.
 */
#ifndef lms3dRangeImage_h
#define lms3dRangeImage_h

#include "Device/lms3dScanGeometry.h"

class vtkDoubleArray;
class vtkImageData;
class vtkInformation;
class vtkInformationVector;

/// One of the pieces into which VTK divides an image.
struct lms3dImagePiece
{
  int Number;
  int Count;
  int GhostLevels;
};

/// Sets extent, origin, spacing (degrees) and scalar type in the information of all outputs: the
/// pipeline passes the extent on from the scan to a filter that makes a new image of it. The
/// resolutions must be at least 1.
void lms3dDescribeRangeImage(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, vtkInformationVector* outputs);

/// Sets the same in the information of one output, for the image of a scan that exists.
void lms3dDescribeRangeImage(const lms3dScanGeometry& geometry, vtkInformation* info);

/// Fills the whole image, which then shares `ranges`: one value for each beam, ordered by turn,
/// then by beam.
void lms3dFillRangeImage(
  const lms3dScanGeometry& geometry, vtkDoubleArray* ranges, vtkImageData* image);

/// Fills one piece of the image with a copy of its part of `ranges`, the whole grid. The image
/// stays empty if VTK's division leaves nothing for this piece.
void lms3dFillRangeImagePiece(const lms3dScanGeometry& geometry, const double* ranges,
  const lms3dImagePiece& piece, vtkImageData* image);

#endif
