// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The two outputs of vtkLMS3DScanFilter, filled from the ranges of a scan.
 */
#ifndef lms3dScanOutput_h
#define lms3dScanOutput_h

#include "lms3dScanner.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>

#include <cstddef>
#include <vector>

class vtkImageData;
class vtkInformation;
class vtkPolyData;

/// Sets extent, origin and spacing (degrees) and the scalar type of the range image to come.
void lms3dDescribeRangeImage(const lms3dScanGeometry& geometry, vtkInformation* info);

/// All methods are to be called in the TBB arena whose threads they use.
class lms3dScanOutput
{
public:
  lms3dScanOutput(const lms3dScanGeometry& geometry, const lms3dPose& pose);

  bool Cast(
    const lms3dRayCaster& caster, const lms3dRangeLimits& limits, const lms3dProgress& progress);

  void FillScan(const lms3dRayCaster& caster, vtkPolyData* scan) const;

  /// Hands the ranges themselves over, without a copy.
  void FillRangeImage(vtkImageData* image) const;

private:
  struct Returns;
  Returns CountReturns() const;
  void FillTurn(int turn, std::size_t slot, const lms3dRayCaster& caster,
    const lms3dScanGeometry::Directions& directions, const Returns& returns) const;
  void AddFieldData(vtkPolyData* scan) const;

  const lms3dScanGeometry& Geometry;
  const lms3dPose Pose;
  vtkNew<vtkDoubleArray> Ranges;
  std::vector<std::int32_t> Triangles;
};

#endif
