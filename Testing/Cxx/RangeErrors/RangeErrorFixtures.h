// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan and the filter that adds errors to its ranges.
 */
#ifndef RangeErrorFixtures_h
#define RangeErrorFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

struct RangeErrorPipeline
{
  explicit RangeErrorPipeline(vtkDataObject* scene);

  /// Updates both filters. Fails the test if there is an error.
  void Run();

  /// Reported minus true range of each return, metres. Needs a filter that removed no return.
  std::vector<double> GetErrors();

  vtkSmartPointer<vtkLMS3DScanFilter> Scan;
  vtkNew<vtkLMS3DRangeErrorFilter> Errors;
};

/// A room with open windows: some beams have no return.
vtkSmartPointer<vtkPolyData> MakeOpenScene();

/// A copy that shares no array.
vtkSmartPointer<vtkPolyData> CopyData(vtkPolyData* data);

/// The ranges of returns, and of all beams.
std::vector<double> GetRanges(vtkPolyData* scan);
std::vector<double> GetRanges(vtkImageData* image);

/// Turns on a bias, noise and a resolution.
void AddAllErrors(vtkLMS3DRangeErrorFilter* filter);

/// Fails the test if the image does not have the ranges of the scan's beams.
void ExpectImageOfScan(vtkImageData* image, vtkPolyData* scan);

/// Fails the test if an output has points or arrays.
void ExpectEmpty(vtkLMS3DRangeErrorFilter* filter);

struct Moments
{
  explicit Moments(const std::vector<double>& values);

  double Count;
  double Mean;
  double Variance;
  /// Central moments divided by powers of the standard deviation; 0 and 3 for a normal
  /// distribution.
  double Skewness;
  double Kurtosis;
};

/// The correlation of values with the values `lag` places later.
double GetCorrelation(const std::vector<double>& values, std::size_t lag);
double GetCorrelation(const std::vector<double>& one, const std::vector<double>& other);

#endif
