// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The two outputs of vtkLMS3DScanFilter, filled from the ranges of a scan.
 */
#ifndef lms3dScanOutput_h
#define lms3dScanOutput_h

#include "lms3dMemoryPool.h"
#include "lms3dScanner.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkImageData;
class vtkInformation;
class vtkPolyData;

/// Sets extent, origin and spacing (degrees) and the scalar type of the range image to come.
void lms3dDescribeRangeImage(const double alphaRange[2], int alphaResolution,
  const double betaRange[2], int betaResolution, vtkInformation* info);

/**
 * Makes the outputs of one scan after the other, in memory that is used again. All methods are to
 * be called in the TBB arena whose threads they use.
 */
class lms3dScanOutput
{
public:
  /// Lets go of what a Cast made that was stopped, or that failed.
  void Discard();

  /// Casts all beams; false where `progress` stopped it.
  bool Cast(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dRangeLimits& limits, const lms3dProgress& progress);

  /// The outputs of the last Cast with the same arguments; hands its ranges over to the image.
  void FillScan(const lms3dTriangleMesh& mesh, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, vtkPolyData* scan);
  void FillRangeImage(const lms3dScanGeometry& geometry, vtkImageData* image);

private:
  struct Returns;
  struct TurnSource;
  std::vector<std::size_t> CountReturns(const lms3dScanGeometry& geometry) const;
  void FillTurn(int turn, std::size_t slot, const lms3dTriangleMesh& mesh,
    const lms3dScanGeometry& geometry, const lms3dBeamDirections& directions,
    const std::array<double, 3>& position, const Returns& returns) const;

  lms3dMemoryPool Pool;
  vtkSmartPointer<vtkDoubleArray> Ranges;
  std::vector<std::int32_t> Triangles;
};

#endif
