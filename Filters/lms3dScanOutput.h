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
#include <vtkType.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkImageData;
class lms3dProcesses;
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

  ///@{
  /**
   * The same for the scene's part that this process has, with no caster where it has none, and then
   * of the results of all processes the nearest. Triangles of this part belong to cells numbered from
   * `firstCell`.
   */
  bool CastPart(const lms3dRayCaster* caster, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress);
  void TakeNearest(
    const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell);
  ///@}

  /// The outputs of the last Cast with the same arguments, without a mesh after TakeNearest; hands
  /// its ranges over to the image.
  void FillScan(const lms3dTriangleMesh* mesh, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, vtkPolyData* scan);
  void FillRangeImage(const lms3dScanGeometry& geometry, vtkImageData* image);

  /// After TakeNearest: the part of the image that VTK asks a process for.
  void FillRangeImagePart(const lms3dScanGeometry& geometry, const lms3dProcesses& processes,
    int ghostLevels, vtkImageData* image);

private:
  struct Returns;
  struct TurnSource;
  std::vector<std::size_t> CountReturns(const lms3dScanGeometry& geometry) const;
  void MakeRoom(std::size_t beams);
  void FillTurn(int turn, std::size_t slot, const lms3dTriangleMesh* mesh,
    const lms3dScanGeometry& geometry, const lms3dBeamDirections& directions,
    const std::array<double, 3>& position, const Returns& returns) const;

  lms3dMemoryPool Pool;
  vtkSmartPointer<vtkDoubleArray> Ranges;
  std::vector<std::int32_t> Triangles;

  /// What a part of the scene chose for each beam, only where there are several.
  std::vector<double> ChosenRanges;
  std::vector<std::int32_t> ChosenTriangles;
  std::vector<vtkIdType> Cells;
};

#endif
