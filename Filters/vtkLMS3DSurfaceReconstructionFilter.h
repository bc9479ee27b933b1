// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DSurfaceReconstructionFilter
 * @brief   reconstructs the local map, a surface of triangles, from the returns of a scan
 *
 * vtkLMS3DSurfaceReconstructionFilter takes a scan of vtkLMS3DScanFilter and reconstructs the local
 * map: a surface of few triangles within a given distance of every return. The paper shows a local
 * map in section 2.1 and Figure 5. If the scan covers a full circle, its seam is closed. The beams
 * of all turns coincide at a pole, which becomes one vertex.
 *
 * With a MaximumError above 0, the filter fits planes to the returns, straightens the borders
 * between the planar patches, and triangulates the patches. Then it compares every return with the
 * triangle that its beam hits. If the return is too far away, the beam becomes a vertex. Therefore
 * the bound holds for every return of any scene. If patches would have fewer than twenty returns on
 * average, or if the noise of the ranges exceeds three quarters of the bound, the filter makes the
 * plain grid instead. A return without neighbours on its surface gets a facet, a small triangle
 * that faces the sensor, so no return is lost. Then the filter removes the vertices that the bound
 * does not need. Where patches join smoothly, as on curved surfaces, it also moves vertices to
 * where they fit the returns around them best. At last, all vertices move along their directions
 * from the sensor, so that the map fits the returns better, within the bound and, at depth steps,
 * within what the returns support. (With a mirror beside the axis or a turning platform, no vertex
 * moves, and the border of the surface stays. If the beams are farther apart than 5,000 beams all
 * around would be, all vertices stay.) Bounds below four standard deviations of the noise need more
 * triangles. With noise, the bound counts from the noisy returns. The surface extends beyond the
 * last returns by less than a cell of the grid, on average midway to the next beam.
 *
 * With a MaximumError of 0, the filter makes the plain grid: every return is a vertex (at a pole
 * the return of median range), and a cell of the grid of beams and turns has two triangles, divided
 * along the shorter diagonal, if its four returns are on one surface. A return without neighbours
 * on its surface is a point without a triangle.
 *
 * No triangle crosses a depth step. Two neighbouring returns lie on one surface if
 *
 * - their ranges differ by at most DepthStep; or
 * - the planes through the returns on both sides explain the difference. Each plane meets the other
 *   return within 2 cm (less if DepthStep is below 10 cm) and what noise can do, so a floor at a
 *   grazing angle stays whole; or the planes intersect between the two, as floor and wall do, and
 *   the last three returns of the side that goes on behind the other lie on one plane. If only two
 *   returns show that plane, the surface must be whole all around. So a closed room stays closed in
 *   the coarsest scan, with noise as well; or
 * - their ranges differ by at most DepthStep plus 2 % of the nearer range, and no step of 1.8 times
 *   DepthStep fits between the planes. In scans coarser than 1.15 degrees, the angle between
 *   neighbours, in radians, replaces the 2 %; or
 * - the surface between them would be seen at a gentle angle of incidence, as between the waves of
 *   the ground. If neighbours are at most 1.15 degrees apart, these are angles up to 72 degrees
 *   where one plane meets the other return, up to 63 degrees where both planes are steeper, and
 *   along a fan up to 68 degrees where the nearer side is curved and does not end in front of the
 *   farther one. If neighbours are at most two degrees apart, these are angles up to 27 degrees
 *   where both planes are steeper or both sides are curved; or
 * - beams of a fan at most two degrees apart graze one plane, as that of a table's top: the same
 *   two beams of at least five turns, and a third return in the fan, show it (unless the platform
 *   turns during a fan); or
 * - the surface is whole around them, neighbours are at most two degrees apart, and the surface
 *   between them would be seen at an angle of incidence up to 45 degrees. The surface is whole if
 *   one of the two grid cells beside the pair has no other open side, and the other cell at most
 *   two. This holds only where DepthStep plus 2 % of the nearer range (or plus the share that
 *   replaces the 2 %) is from 6 to 30 times DepthStep: there, hills and steps look alike.
 *
 * If that sum exceeds 6 times DepthStep, some returns within it are not on one surface: their
 * ranges differ by more than twice DepthStep, one plane misses the other return by more than five
 * times DepthStep, the other plane by more than half of it, and at least three of the six other
 * sides of the cells beside the pair are open. Cells beyond the edge of the scan do not count. (If
 * the platform turns during a fan, this holds only from turn to turn.)
 *
 * The filter estimates the noise from the scan itself. If noise leaves two neighbours open, the
 * mean over the pairs beside them decides. Noise beyond half of DepthStep counts as steps.
 *
 * Returns are never joined across a beam without a return, unless MaximumGapSize closes the gap, or
 * across 180 degrees or more. (A return that lies by chance in the plane of nearer returns cannot
 * be distinguished from their surface.)
 *
 * @par Gaps and speckles
 * Real devices lose beams and report stray ranges. With a MaximumError above 0, MaximumGapSize
 * closes gaps of lost beams, and MaximumSpeckleSize takes stray returns out of the surface. In
 * both, the surface around a group of beams goes on if the returns next to the group, diagonals
 * included, lie on one plane. (If there are fewer than five of them, the lost beams and speckles
 * next to the group belong to it as well, unless the group is a speckle behind the plane: its beams
 * may have met no surface there.) Three of these returns must stand in an angle, two of them in one
 * fan and two in one turn. The plane explains a return within 0.8 of MaximumError or four standard
 * deviations of the noise, but never returns on both sides of a depth step. At the edge of the
 * scan, and beside a beam along which there is nothing, the surface does not go on. A missing pole
 * stays open. For beams without a return, and for the surface behind or before a speckle,
 * MaximumError counts from this plane.
 *
 * If the triangles at a gap do not pass the filter's checks, the gap stays open. If the map becomes
 * the plain grid, because of noise or too many patches, all gaps stay open, and the returns of
 * speckles are returns of the grid, or left out if KeepSpeckles is off.
 *
 * @par Mountings, and mirrors beside the axis
 * The filter understands every Mounting, AxisOffset and TurnRate of vtkLMS3DScanFilter.
 * MaximumError holds for all of them.
 *
 * - Yawing and Pitching: the grid of the map has the turns and beams of the scan.
 * - YawingTop and Rolling: each half of the fan becomes a turn of its own, with a pole at alpha 0.
 *   The surface closes around the axis if there is a beam at alpha 0 and if the step of beta
 *   divides 180 degrees; otherwise there is a slit at the first turn. Turns at 180 degrees or more
 *   from the first one measure the same directions again. The map leaves them out, and MaximumError
 *   does not count for them. (So choose a BetaRange of 0 to 180.)
 * - AxisOffset: depth steps compare ranges from where the beams start, and a beam of the error
 *   check starts there as well. "Towards the sensor", and `Range` of the map, mean the point of the
 *   platform's axis at the height of the mirror's centre. A mirror beside the axis sees neither
 *   pole, so the surface has a hole there, about as large as the offset. If the mirror lies behind
 *   the axis, beams near the pole pass the axis, and measure what other turns measure as well:
 *   these returns get facets, unless they lie within MaximumError of the map, and in the plain
 *   grid, they are points without triangles. With an offset across the fan, the halves of the fans
 *   of YawingTop and Rolling do not continue each other: at the first turn, the surface has two
 *   layers on one side and a slit on the other. Near a border between patches, the triangle within
 *   MaximumError of a return can belong to the patch beside it. Where triangles do not fit the
 *   beams, only the returns beside the place leave their patch, and become patches or facets of
 *   their own. On planes, the number of triangles is about that of a mirror on the axis. On curved
 *   surfaces, it is larger, because vertices are removed, but not moved. The map takes longer,
 *   because all beams are cast at it: some tenths of a second for the default scan with a mirror
 *   0.1 m ahead of the axis, and several seconds with larger offsets across the fan.
 * - TurnRate: neighbours in a fan are compared at one platform angle, so interlaced fans do not
 *   tear the surface into strips. If the platform turns by several steps of beta during one fan,
 *   borders between patches follow the comb of the interlaced beams, which needs several times as
 *   many triangles.
 *
 * The points of a scan with MotionDuringScan assume a resting sensor, and so does the map.
 *
 * The input needs the point data `Range` and `BeamId`, and the field data `AlphaAngles`,
 * `BetaAngles` and `SensorToWorld` of the scan, and, if not default, `Mounting`, `AxisOffset` and
 * `TurnRate`. Returns may have been removed or moved. Each beam may have at most one return. With a
 * MaximumError above 0, a return lies on its beam at its `Range`; the coordinates of the points are
 * not used. A scan of one turn or of one beam has no cells, so its plain grid has no triangles.
 *
 * The output is a vtkPolyData of triangles that face the sensor, in world coordinates, metres. It
 * has the point data `Range` (float64, metres from the sensor) and `Normals` (float32, unit vectors
 * towards the sensor). The plain grid has normals at its points, the means of the adjacent
 * triangles' normals; a bounded map has normals of its triangles. The points of the plain grid are
 * the returns, with one for each pole; a point without triangles has the direction to the sensor as
 * its normal. A bounded map has these arrays as well:
 *
 * - cell data `PatchId` (int32): the patch from which the triangle comes; a facet is a patch of its
 *   own. It is -1 for triangles that join two patches along an offset within one surface, and for
 *   the plain grid.
 * - field data `NumberOfPatches`, `NumberOfReturns`, and its parts `NumberOfReturnsOnPatches`,
 *   `NumberOfReturnsOnGrid` (of the plain grid) and `NumberOfReturnsOnFacets`. A scan of YawingTop
 *   or Rolling over 180 degrees or more has `NumberOfReturnsOnRepeatedTurns` as well.
 * - field data `LargestDeviation` (float64, metres): the largest distance from a return to the
 *   triangle that its beam hits.
 * - if gaps may be closed, field data `NumberOfClosedGaps`, `ClosedGapArea` (float64, square
 *   metres; the beams of a plane share its area) and `ClosedBeamIds` (int32): the BeamIds of the
 *   beams without a return in closed gaps, in growing order.
 * - if MaximumSpeckleSize is above 0, field data `NumberOfSpeckles`, `NumberOfReturnsOnSpeckles`,
 *   another part of `NumberOfReturns`, and `SpeckleBeamIds` (int32, in growing order).
 *
 * Invalid input gives an error message that says what is expected, the error code
 * vtkErrorCode::UserError, and an empty output. Invalid are: a missing array; a coordinate, angle
 * or pose that is not finite; a range that is not a finite number above 0; a BeamId outside of the
 * grid or of two returns. For a bounded map, invalid are also elevations beyond 90 degrees, turns
 * over more than a full circle, angles that neither strictly increase nor strictly decrease, and
 * scans of more than 268435455 directions. The filter reports an error once, until a property or an
 * input changes. A scan without returns gives an empty map and no error. The output is the same to
 * the bit for any NumberOfThreads.
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
   * The error bound of the map, metres, at least 0. Each beam with a return hits the surface within
   * this distance of the return, so no return is farther from the surface. The returns of a pole
   * are one vertex: if their ranges span more than twice the bound, the returns farther than the
   * bound from their median get facets. 0 makes every return a vertex. Values below 0 become 0;
   * not-a-number is an error. The default is 0.01.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * The largest difference in range, metres, at least 0, between neighbouring returns of one
   * surface, unless their planes explain a larger one. Where the planes leave it open, a share of
   * the nearer range, at least 2 %, is added. A smaller value separates objects from what is close
   * behind them; a larger value bridges more. Values below 0 become 0; not-a-number is an error.
   * The default is 0.1.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /**
   * The largest gap that the map closes, beams, -1 to 1,000,000. A gap is a group of neighbouring
   * beams, along the fan and along the turn, without a return. It is closed if the returns around
   * it lie on one plane. A gap at the edge of the scan stays open, and so does one with a beam in
   * it or next to it that met nothing, or whose surface was beyond the range, according to the
   * field data `Status` of the scan. (Beams whose return was too weak or too near, or was removed
   * later, do not show free space.) -1, the default, closes gaps of up to 25 beams in scans that
   * have `Status`, and none in others. 0 closes none. Without `Status`, lost beams cannot be
   * distinguished from a hole of the same size. The plain grid has its gaps open.
   */
  vtkSetClampMacro(MaximumGapSize, int, -1, 1000000);
  vtkGetMacro(MaximumGapSize, int);
  ///@}

  ///@{
  /**
   * The largest speckle, returns, 0 to 1,000,000. A speckle is a group of neighbouring returns
   * that lies off the plane of all returns around it, nearer or farther. The surface goes on behind
   * a nearer speckle and in front of a farther one. There are two kinds:
   * - Returns at one depth, on one surface with none around them. Returns are at one depth if they
   *   differ by no more than DepthStep and the share of the range. Diagonal neighbours belong to
   *   one group, and so do returns on both sides of a lost beam: a thin thing that beams meet in
   *   one turn after the other is one group.
   * - Returns at one depth with the surface that stand out of it, along the fan and along the turn,
   *   by at least 1.6 times MaximumError or, if that is more, eight standard deviations of the
   *   noise. A group two returns wide must stand out by twice as much, and a wider one never does.
   *
   * Small objects, thin things that only some turns meet, and small windows with something behind
   * them cannot be distinguished from speckles. 0, the default, treats every return as a part of
   * the surface.
   */
  vtkSetClampMacro(MaximumSpeckleSize, int, 0, 1000000);
  vtkGetMacro(MaximumSpeckleSize, int);
  ///@}

  ///@{
  /**
   * Whether each return of a speckle gets a facet, so that MaximumError holds for it. Otherwise,
   * the map leaves speckles out. On by default.
   */
  vtkSetMacro(KeepSpeckles, bool);
  vtkGetMacro(KeepSpeckles, bool);
  vtkBooleanMacro(KeepSpeckles, bool);
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
  int MaximumGapSize = -1;
  int MaximumSpeckleSize = 0;
  bool KeepSpeckles = true;
  int NumberOfThreads = 0;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
