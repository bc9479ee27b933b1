// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DSurfaceReconstructionFilter
 * @brief   reconstructs the local map, a surface of triangles, from the returns of a scan
 *
 * vtkLMS3DSurfaceReconstructionFilter takes a scan of vtkLMS3DScanFilter and reconstructs the local map:
 * a surface of few triangles within a given distance of every return. (Noise at a pole can exceed it.)
 * The paper shows a local map in section 2.1 and Figure 5. If the scan covers a full circle, its seam is
 * closed. The beams of all turns coincide at a pole; there the return of median range counts.
 *
 * With a MaximumError above 0, the filter fits planes to the returns, straightens the borders between the
 * planar patches, and triangulates the patches. Then it compares every return with the triangle that its
 * beam hits. If the return is too far away, the beam becomes a vertex. Therefore the bound holds for every
 * return of any scene; see MaximumError for poles. If patches would have fewer than twenty returns on
 * average, or if the noise of the ranges exceeds three quarters of the bound, the filter makes the plain
 * grid instead. A return without neighbours on its surface gets a facet, a small triangle that faces the
 * sensor, so no return is lost. Curved surfaces, and bounds below four standard deviations of the noise,
 * need more triangles. With noise, the bound counts from the noisy returns. The surface extends beyond the
 * last returns by less than a cell of the grid, on average midway to the next beam.
 *
 * With a MaximumError of 0, the filter makes the plain grid: every return is a vertex, and a cell of the
 * grid of beams and turns has two triangles, divided along the shorter diagonal, if its four returns are
 * on one surface. A return without neighbours on its surface is a point without a triangle.
 *
 * No triangle crosses a depth step. Two neighbouring returns lie on one surface if
 *
 * - their ranges differ by at most DepthStep plus 2 % of the nearer range; in scans coarser than 1.15
 *   degrees, the angle between neighbours, in radians, replaces the 2 %; or
 * - the plane through either return and the returns before it meets the other within that tolerance, so
 *   a floor at a grazing angle stays whole; or
 * - the planes from both sides intersect between the two, as floor and wall do, and the last three
 *   returns of the nearer side lie on one plane, or the surface is whole all around. So a closed room
 *   without noise stays closed in the coarsest scan.
 *
 * Returns are never joined across a beam without a return, or across 180 degrees or more. (A return that
 * lies by chance in the plane of nearer returns cannot be distinguished from their surface.)
 *
 * @par Mountings, and mirrors beside the axis
 * The filter understands every Mounting, AxisOffset and TurnRate of vtkLMS3DScanFilter. MaximumError holds
 * for all of them.
 *
 * - Yawing and Pitching: the grid of the map has the turns and beams of the scan.
 * - YawingTop and Rolling: each half of the fan becomes a turn of its own, with a pole at alpha 0. The
 *   surface closes around the axis if there is a beam at alpha 0 and if the step of beta divides 180
 *   degrees; otherwise there is a slit at the first turn. Turns at 180 degrees or more from the first one
 *   measure the same directions again. The map leaves them out, and MaximumError does not count for them.
 *   (So choose a BetaRange of 0 to 180.)
 * - AxisOffset: depth steps compare ranges from where the beams start, and a beam of the error check starts
 *   there as well. "Towards the sensor", and `Range` of the map, mean the point of the platform's axis at the
 *   height of the mirror's centre. A mirror beside the axis sees neither pole, so the surface has a hole
 *   there, about as large as the offset. If the mirror lies behind the axis, beams near the pole pass
 *   the axis, and measure what other turns measure as well: these returns get facets, unless they lie within
 *   MaximumError of the map, and in the plain grid, they are points without triangles.
 *   With an offset across the fan, the halves of the fans of YawingTop and Rolling do not continue each other:
 *   at the first turn, the surface has two layers on one side and a slit on the other.
 *   Near a border between patches, the triangle within MaximumError of a return can belong to the patch beside
 *   it. Where triangles do not fit the beams, only the returns beside the place leave their patch, and become
 *   patches or facets of their own. The number of triangles is about that of a mirror on the axis. The map takes
 *   longer, because all beams are cast at it: a quarter of a second for the default scan with a mirror 0.1 m
 *   ahead of the axis, and several seconds with larger offsets across the fan.
 * - TurnRate: neighbours in a fan are compared at one platform angle, so interlaced fans do not tear
 *   the surface into strips. If the platform turns by several steps of beta during one fan, borders between
 *   patches follow the comb of the interlaced beams, which needs several times as many triangles.
 *
 * The points of a scan with MotionDuringScan assume a resting sensor, and so does the map.
 *
 * The input needs the point data `Range` and `BeamId`, and the field data `AlphaAngles`, `BetaAngles` and
 * `SensorToWorld` of the scan, and, if not default, `Mounting`, `AxisOffset` and `TurnRate`. Returns may have
 * been removed or moved. Each beam may have at most one return. With a MaximumError above 0, a return lies on
 * its beam at its `Range`; the coordinates of the points are not used. A scan of one turn or of one beam has
 * no cells, so its plain grid has no triangles.
 *
 * The output is a vtkPolyData of triangles that face the sensor, in world coordinates, metres. It has the
 * point data `Range` (float64, metres from the sensor) and `Normals` (float32, unit vectors towards the
 * sensor). The plain grid has normals at its points, the means of the adjacent triangles' normals; a bounded
 * map has normals of its triangles. The points of the plain grid are the returns, with one for each pole; a
 * point without triangles has the direction to the sensor as its normal. A bounded map has these arrays as
 * well:
 *
 * - cell data `PatchId` (int32): the patch of the triangle; a facet is a patch of its own. It is -1 for
 *   triangles that join two patches along an offset within one surface, and for the plain grid.
 * - field data `NumberOfPatches`, `NumberOfReturns`, and its parts `NumberOfReturnsOnPatches`,
 *   `NumberOfReturnsOnGrid` (of the plain grid) and `NumberOfReturnsOnFacets`. A scan of YawingTop or
 *   Rolling over 180 degrees or more has `NumberOfReturnsOnRepeatedTurns` as well.
 * - field data `LargestDeviation` (float64, metres): the largest distance from a return to the triangle
 *   that its beam hits.
 *
 * Invalid input gives an error message that says what is expected, the error code
 * vtkErrorCode::UserError, and an empty output. Invalid are: a missing array; a coordinate, angle or pose
 * that is not finite; a range that is not a finite number above 0; a BeamId outside of the grid or of two
 * returns. For a bounded map, invalid are also elevations beyond 90 degrees, turns over more than a full
 * circle, angles that neither strictly increase nor strictly decrease, and scans of more than 268435455
 * directions. The filter reports an error once, until a property or an input changes. A scan without
 * returns gives an empty map and no error. The output is the same to the bit for any NumberOfThreads.
 *
 * @sa
 * vtkLMS3DScanFilter vtkLMS3DRangeErrorFilter
 */
#ifndef vtkLMS3DSurfaceReconstructionFilter_h
#define vtkLMS3DSurfaceReconstructionFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class VTKLMS3DFILTERS_EXPORT vtkLMS3DSurfaceReconstructionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DSurfaceReconstructionFilter* New();
  vtkTypeMacro(vtkLMS3DSurfaceReconstructionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The error bound of the map, metres, at least 0. Each beam with a return hits the surface within this
   * distance of the return, so no return is farther from the surface. The returns of a pole are one
   * vertex: if their ranges span more than twice the bound, it holds for the returns within the bound of
   * their median. 0 makes every return a vertex. Values below 0 become 0; not-a-number is an error. The
   * default is 0.01.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * The largest difference in range, metres, at least 0, between neighbouring returns of one surface,
   * unless a plane explains a larger one. A share of the nearer range, at least 2 %, is added. A smaller
   * value separates objects from what is close behind them; a larger value bridges more. Values below 0
   * become 0; not-a-number is an error. The default is 0.1.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024. 0, the default, uses all cores. Other values are clamped. The
   * output does not depend on it.
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

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
