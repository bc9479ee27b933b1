// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The range image of a scan: the grid of ranges, elevations along x and turns along y.
 */
#ifndef lms3dRangeImage_h
#define lms3dRangeImage_h

#include "Device/lms3dScanGeometry.h"

class vtkDoubleArray;
class vtkImageData;
class vtkInformation;

/// One of the pieces that VTK divides an image into.
struct lms3dImagePiece
{
  int Number;
  int Count;
  int GhostLevels;
};

/// Sets extent, origin and spacing (degrees) and the scalar type of the range image to come.
void lms3dDescribeRangeImage(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, vtkInformation* info);

/// The whole image. `ranges` become its own.
void lms3dFillRangeImage(
  const lms3dScanGeometry& geometry, vtkDoubleArray* ranges, vtkImageData* image);

/// A piece of it; empty where there are more pieces than rows.
void lms3dFillRangeImagePiece(const lms3dScanGeometry& geometry, const double* ranges,
  const lms3dImagePiece& piece, vtkImageData* image);

#endif
