// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The two outputs of vtkLMS3DScanFilter, filled from the ranges of a scan.
 */
#ifndef lms3dScanOutput_h
#define lms3dScanOutput_h

#include "Device/lms3dRangeImage.h"
#include "Pipeline/lms3dMemoryPool.h"
#include "Scan/lms3dScanner.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkImageData;
class lms3dProcesses;
class vtkPolyData;

/**
 * Makes the outputs of one scan after the other, in memory that is used again. Cast,
 * CastPart and FillScan are to be called in the TBB arena whose threads they use.
 */
class lms3dScanOutput
{
public:
  /// Lets go of what a Cast made that was stopped, or that failed.
  void Discard();

  /// Casts all beams; false where `progress` stopped it.
  bool Cast(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dRangeLimits& limits, const lms3dProgress& progress);

  ///@{
  /**
   * The same for the scene's part that this process has, with no caster where it has none, and then
   * of the results of all processes the nearest. Triangles of this part belong to cells numbered from
   * `firstCell`.
   */
  bool CastPart(const lms3dRayCaster* caster, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress);
  void ReduceToNearest(
    const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell);
  ///@}

  /// The outputs of the last Cast with the same arguments, without a mesh after ReduceToNearest; hands
  /// its ranges over to the image.
  void FillScan(const lms3dTriangleMesh* mesh, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, vtkPolyData* scan);
  void FillRangeImage(const lms3dScanGeometry& geometry, vtkImageData* image);

  /// A piece of the image, after ReduceToNearest.
  void FillRangeImagePiece(
    const lms3dScanGeometry& geometry, const lms3dImagePiece& piece, vtkImageData* image) const;

private:
  std::vector<std::size_t> CountReturns(const lms3dScanGeometry& geometry) const;
  void MakeRoom(std::size_t beams);

  lms3dMemoryPool Pool;
  vtkSmartPointer<vtkDoubleArray> Ranges;
  std::vector<std::int32_t> Triangles;

  /// What a part of the scene chose for each beam, only where there are several.
  std::vector<double> ChosenRanges;
  std::vector<std::int32_t> ChosenTriangles;
  std::vector<vtkIdType> Cells;
};

#endif
