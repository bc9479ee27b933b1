// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DSurfaceReconstructionFilter
 * @brief   reconstructs the local map, a surface, from the returns of a scan
 *
 * vtkLMS3DSurfaceReconstructionFilter takes the scan of vtkLMS3DScanFilter and joins neighbouring
 * returns by triangles (the paper's local map, section 2.1 and Figure 5): two for each cell of the
 * grid of beams and turns, along the shorter diagonal. The seam of a full circle is closed, and
 * each pole, where the beams of all turns are one, is one vertex, the return of median range.
 *
 * Triangles never cross a depth step. Two neighbours lie on one surface where their ranges differ
 * by at most DepthStep plus 2 % of the nearer range (in scans coarser than 1.15 degrees the angle
 * between neighbours, in radians, takes the place of the 2 %), or where the plane that goes on from
 * either of them meets the other within that tolerance; so a floor that is met at a grazing angle
 * far away stays whole. Returns are never joined across a beam without one.
 *
 * The input needs the point data `Range` and `BeamId` and the field data `AlphaAngles`,
 * `BetaAngles` and `SensorToWorld` of the scan; returns may have been removed or moved. Each beam
 * may have one return. A scan of one turn or of one beam has no cells, so its map has no triangles.
 *
 * The output is a vtkPolyData of triangles that face the sensor. Its points are the returns (of
 * each pole the one), with the point data `Range` (float64, metres) and unit normals towards the
 * sensor; a return that belongs to no triangle has the direction to the sensor for its normal.
 *
 * Bad input gives an error that says what to do, the error code vtkErrorCode::UserError, and an
 * empty output: a missing array, a coordinate that is not finite, a range that is not a finite
 * number above 0, a BeamId that is out of the grid or that comes twice. A scan without returns gives
 * an empty map and no error. The output is the same to the bit for any NumberOfThreads.
 *
 * @sa
 * vtkLMS3DScanFilter
 */
#ifndef vtkLMS3DSurfaceReconstructionFilter_h
#define vtkLMS3DSurfaceReconstructionFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class lms3dScanInput;

class VTKLMS3DFILTERS_EXPORT vtkLMS3DSurfaceReconstructionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DSurfaceReconstructionFilter* New();
  vtkTypeMacro(vtkLMS3DSurfaceReconstructionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest difference in range, metres, that neighbouring returns of one surface may have
   * where no plane explains it. At least 0; a share of the nearer range, 2 % or more, is added. A
   * smaller value separates things from what is close behind them, a larger one bridges more. The
   * default is 0.1.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024; the default, 0, takes all cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkLMS3DSurfaceReconstructionFilter();
  ~vtkLMS3DSurfaceReconstructionFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DSurfaceReconstructionFilter(const vtkLMS3DSurfaceReconstructionFilter&) = delete;
  void operator=(const vtkLMS3DSurfaceReconstructionFilter&) = delete;

  double DepthStep = 0.1;
  int NumberOfThreads = 0;

  // Within the threads of the calling arena.
  void MakeMap(const lms3dScanInput& scan, vtkPolyData* map);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
