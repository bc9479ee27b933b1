// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A map comparison with its inputs, and ways to check its results.
 */
#ifndef ComparisonFixtures_h
#define ComparisonFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DMapComparison.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkTransform;

/// Adds an array to the field data.
void AddDoubles(vtkPolyData* data, const char* name, const std::vector<double>& values);

/// A scan without returns. The sensor stands upright; angles are in degrees.
vtkSmartPointer<vtkPolyData> MakePose(const Point& sensor,
  const std::vector<double>& alphas = { -90.0, 90.0 },
  const std::vector<double>& betas = { 0.0, 120.0, 240.0 });

vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* surface, vtkTransform* transform);

struct Comparison
{
  Comparison(vtkPolyData* map, vtkDataObject* scene, const Point& sensor);
  Comparison(vtkPolyData* map, vtkDataObject* scene, vtkPolyData* scan);

  /// Returns the filter after an update.
  vtkLMS3DMapComparison* Update();

  /// Updates, and returns a result from the field data.
  double GetField(const char* name, int component = 0);

  /// Expects mean, root mean square, 95th percentile and maximum in the field data.
  void ExpectErrors(const char* name, const std::array<double, 4>& expected, double allowed);

  /// Expects an error that contains a text, and no results.
  void ExpectError(const std::string& text);

  /// Expects empty outputs, and getters that return NaN.
  void ExpectNoResults();

  /// Updates, and returns the second output.
  vtkPolyData* GetScenePoints();

  vtkNew<vtkLMS3DMapComparison> Filter;
};

#endif
