// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The errors of a map against the scene and the scan.
 */
#ifndef MapErrors_h
#define MapErrors_h

#include "Scenes.h"

#include "vtkLMS3DMapComparison.h"

#include <vtkNew.h>

#include <string>

/// What vtkLMS3DMapComparison finds, by the names of its results.
class MapErrors
{
public:
  MapErrors(const BenchmarkScene& scene, vtkPolyData* scan, vtkPolyData* map);

  /// A component of a result, times a factor, with a fixed count of digits after the point.
  std::string Format(const char* name, double factor, int decimals, int component = 0) const;

  /// Half of the Chamfer distance, metres: a map that leaves out what is hard gains in one
  /// direction, and loses in the other.
  double GetMeanOfBoth() const;

private:
  double Get(const char* name, int component) const;

  vtkNew<vtkLMS3DMapComparison> Comparison;
};

#endif
