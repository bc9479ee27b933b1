// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The decimated grid that is as near to the returns as a map within a bound.
 */
#ifndef EqualDecimation_h
#define EqualDecimation_h

#include "MapContender.h"
#include "Scenes.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

/// Decimates the plain grid by vtkQuadricDecimation until it leaves the bound of a return. Returns
/// that the grid leaves out do not count.
class EqualDecimation
{
public:
  /// Keeps references. The grid is made of the scan.
  EqualDecimation(const BenchmarkScene& scene, vtkPolyData* scan, const MapContender& grid);

  /// About the smallest number of triangles, to 2 %, with which no return is farther than
  /// `bound`, metres, from the decimated grid. There is none if the grid needs them all.
  std::optional<vtkIdType> FindTriangles(double bound) const;

private:
  double GetLargestDistance(vtkIdType triangles) const;

  const BenchmarkScene& Scene;
  const MapContender& Grid;
  vtkSmartPointer<vtkPolyData> Scan;
};

#endif
