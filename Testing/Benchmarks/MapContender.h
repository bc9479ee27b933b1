// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ways to a map of a scan: the filter of LMS3D, and what else VTK has for it.
 */
#ifndef MapContender_h
#define MapContender_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

struct MapContender
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Map;
  /// From the scan to the map, one thread.
  double Milliseconds;
};

/// The scan as a sensor with Gaussian noise along its beams would have it, the same each time.
vtkSmartPointer<vtkPolyData> AddRangeNoise(vtkPolyData* scan, double sigma);

/// The bound, metres, of the map whose number of triangles its rivals get. With noise it is four
/// standard deviations: below, a surface that meets every bound has to follow the noise.
double GetFairBound(double noise);

/// The time of each is the best of the runs within a budget (ms), or that of the first and only
/// one.

/// MaximumGapSize and MaximumSpeckleSize of vtkLMS3DSurfaceReconstructionFilter.
struct MapGaps
{
  int MaximumGapSize = -1;
  int MaximumSpeckleSize = 0;
};

/// vtkLMS3DSurfaceReconstructionFilter with a bound and a DepthStep in metres, on one thread.
MapContender MakeLocalMap(vtkPolyData* scan, double maximumError, double depthStep, double budget,
  const MapGaps& gaps = {});

/// The grid, decimated to a number of triangles.
MapContender DecimateByQuadrics(const MapContender& grid, vtkIdType triangles, double budget);
MapContender DecimatePro(const MapContender& grid, vtkIdType triangles, double budget);

/// vtkSurfaceReconstructionFilter, which uses only the points, at a hundredth of the diagonal of
/// their box.
MapContender ReconstructFromPoints(vtkPolyData* scan, double budget);

#endif
