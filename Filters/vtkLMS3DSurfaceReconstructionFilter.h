// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DSurfaceReconstructionFilter
 * @brief   reconstructs the local map, a surface, from the returns of a scan
 *
 * vtkLMS3DSurfaceReconstructionFilter takes the scan of vtkLMS3DScanFilter and makes a surface of
 * triangles (the paper's local map, section 2.1 and Figure 5), of no more of them than MaximumError
 * asks for. The seam of a full circle is closed, and each pole, where the beams of all turns are
 * one, counts as the return of median range.
 *
 * With a MaximumError above 0, planes are fitted to the returns, the borders of the patches that
 * they explain are straightened, and the patches triangulated. Then every return is compared with
 * the triangle that its beam meets, and where it is too far, its beam becomes a vertex; so the bound
 * holds for each return, whatever the scene (of poles, see MaximumError). Where patches would have
 * fewer than twenty returns on average, or the noise of the ranges reaches three quarters of the
 * bound, the plain grid is made in place of that.
 * A return that neighbours none gets a small triangle that faces the sensor, so nothing that was
 * measured is lost. On curved things and below four standard deviations of noise, the map has more
 * triangles; the bound then counts from the noisy returns. Beyond the last returns of a surface it
 * goes on by less than a cell of the grid, midway to the next beam on average.
 *
 * With a MaximumError of 0, every return is a vertex, with two triangles for each cell of the grid of
 * beams and turns, along the shorter diagonal.
 *
 * Triangles never cross a depth step. Two neighbours lie on one surface where their ranges differ
 * by at most DepthStep plus 2 % of the nearer range (in scans coarser than 1.15 degrees the angle
 * between neighbours, in radians, takes the place of the 2 %), or where the plane that goes on from
 * either of them meets the other within that tolerance; so a floor that is met at a grazing angle
 * far away stays whole. They also do where the planes from both sides cross between the two, as
 * floor and wall do, if the last three returns of the nearer side lie on one plane, or if the surface
 * is whole all around; so a closed room stays closed however coarse the scan, without noise. Returns
 * are never joined across a beam without one, nor where beams or turns are 180 degrees apart or more.
 * (What lies on the plane of nearer returns by chance cannot be told from their surface.)
 *
 * The input needs the point data `Range` and `BeamId` and the field data `AlphaAngles`,
 * `BetaAngles` and `SensorToWorld` of the scan; returns may have been removed or moved. Each beam
 * may have one return. (With a MaximumError above 0, a return lies on its beam at its `Range`; the
 * coordinates of the points are not asked.) Of a scan of one turn or of one beam, which has no
 * cells, the plain grid has no triangles.
 *
 * The output is a vtkPolyData of triangles that face the sensor, with the point data `Range`
 * (float64, metres) and `Normals` (float32, units towards the sensor), those of the plain grid at its
 * points, the means of their triangles, and those of a bounded map at its triangles. The points of
 * the plain grid are the returns (of each pole the one); one that belongs to no triangle has the
 * direction to the sensor for its normal. A bounded map has more:
 *
 * - cell data `PatchId` (int32): the triangle's patch, -1 for triangles that join patches across a
 *   step within one surface, and for those of the plain grid; a facet is a patch of its own;
 * - field data `NumberOfPatches`, `NumberOfReturns` and, of these, `NumberOfReturnsOnPatches`,
 *   `NumberOfReturnsOnGrid` (where the plain grid was made) and `NumberOfReturnsOnFacets`;
 * - field data `LargestDeviation` (float64, metres): the largest distance of a return from the
 *   triangle that its beam meets.
 *
 * Bad input gives an error that says what to do, the error code vtkErrorCode::UserError, and an
 * empty output: a missing array, a coordinate, an angle or a pose that is not finite, a range that is
 * not a finite number above 0, a BeamId that is out of the grid or that comes twice; for a bounded map
 * also elevations beyond 90 degrees, turns over more than a full circle, or angles that do not all grow
 * or all fall. A scan without returns gives
 * an empty map and no error. The output is the same to the bit for any NumberOfThreads.
 *
 * @sa
 * vtkLMS3DScanFilter
 */
#ifndef vtkLMS3DSurfaceReconstructionFilter_h
#define vtkLMS3DSurfaceReconstructionFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <functional> // For std::function
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
   * The bound of the map's error, metres, at least 0: each beam that returned meets the surface
   * within this of its return, so no return is farther from the surface. The returns of a pole are
   * one vertex: where they span more than twice the bound, it holds for those that are within the
   * bound of their median. 0 keeps every return as a vertex. The default is 0.01.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

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

  double MaximumError = 0.01;
  double DepthStep = 0.1;
  int NumberOfThreads = 0;

  void CheckProperties() const;
  // Within the threads of the calling arena.
  void MakeMap(
    const lms3dScanInput& scan, const std::function<bool(double)>& progress, vtkPolyData* map);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
