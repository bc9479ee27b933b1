// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DMapFusion
 * @brief   joins the local maps of many scans to one map that grows
 *
 * vtkLMS3DMapFusion takes scans and their local maps, which vtkLMS3DSurfaceReconstructionFilter
 * makes with a MaximumError above 0, and joins them to one surface of few triangles, in world
 * coordinates.
 *
 * Inputs, both optional and repeatable:
 * - 0, the local maps;
 * - 1, the scans from which these maps were made, in the same order.
 *
 * @par How scans are joined
 * The map is a set of planes. Each plane has a raster whose cells, a third of MaximumError wide,
 * know where a local map has surface, where returns lie, and where beams passed through. A planar
 * patch of a local map joins the plane that explains its returns, or becomes a plane. The surface
 * of a plane ends between the returns and the beams that passed, on borders of few corners; where
 * two planes meet, both end on the line in which they intersect. Patches that are curved, or have
 * few returns, are replaced as soon as planes of other scans explain their returns. What no plane
 * explains is shown by the triangles of its local map, or by facets, small triangles around single
 * returns.
 *
 * @par The bound
 * Each return that its local map explains lies within MaximumError of the map, also after more
 * scans. (A local map explains a return if the return's beam hits it within MaximumError, or if one
 * of its corners is as near.) For things that were moved, this holds with ForgetSeenThrough for the
 * returns since then.
 *
 * @par Far returns and small bounds
 * The time and the memory of a scan are bounded by the number of its returns. If a patch of its
 * local map has more than 64 blocks of 64 x 64 cells for each return (neighbouring returns are then
 * about 170 times MaximumError apart), the map has surface between those neighbouring returns alone
 * that are nearer to one another, and small triangles around the others. The limit falls to 16
 * blocks if a scan would have more than 500,000 blocks and more than 16 for each of its returns.
 * With beams 1 degree apart, a wall 5 km away, or a room at a MaximumError of 0.1 mm, becomes a set
 * of small triangles. All poses, returns and points of local maps must lie within 6e8 times
 * MaximumError of the origin (6,000 km by default); a scan that reaches farther is refused.
 *
 * @par Free space
 * A beam passes through a plane if its return is farther than the plane by more than MaximumError,
 * along the beam. There the surface of other scans ends, so that beams without noise meet no
 * triangle nearer than their return by more. (Ranges are kept in single precision: beyond 80 m,
 * this holds within a millionth of the range for a MaximumError of 1 cm.) A beam without a return
 * that met nothing, or a surface beyond the range, passes as if its return were as far as the
 * farthest return of its scan. The scan's field data `Status` say which beams these are. Without
 * `Status`, all beams without a return pass, unless the local map was made with a MaximumGapSize
 * above 0. So the scans of a device that loses beams, or has a minimum range, need `Status`:
 * otherwise each lost beam opens the surface of other scans. A scan whose local map has no
 * triangles shows no free space.
 *
 * What lies between beams is a guess. A scan's guess far behind the planes of the returns around it
 * is left out. Beyond a crease, surface needs a return that it is joined to without a way across a
 * crease. Holes of up to 11 times MaximumError through which no beam passed are closed.
 *
 * @par Noise and errors of poses
 * With noise, the bound counts from the noisy returns. Poses are taken as they are. With errors
 * well below MaximumError, planes stay single. Larger errors double surfaces: each return stays
 * within the bound where its scan reports it, and beams of other scans take out parts of the
 * surface in front.
 *
 * @par Growing
 * If the inputs have time steps, each update at a new time adds the poses of this time, so playing
 * a trajectory makes the map grow. A scan that the map has already is not added twice. A change
 * upstream begins a new map. Without time steps the map is that of all connections. Programs that
 * have data instead of a pipeline call AddScan for each pose, which adds the scan each time; the
 * filter must then have no connections. Regions that explain a new scan keep their triangles. The
 * result depends on the order of the scans.
 *
 * The output is a vtkPolyData of triangles that face the sensors that saw them, metres, with the
 * cell data
 * - `Normals` (float32): unit vectors towards the sensors;
 * - `BestScan` (int32): the scan, counted from 0 in the order in which scans were added, that saw
 *   the region of the triangle best;
 * - `ScanCount` (int32): the number of scans that saw it. If a region gets returns of earlier scans
 *   from another region, their scans may be left out, so the number can be too small;
 * - `LastScan` (int32): the last of them;
 * - `RegionId` (int32): the region; a region is what changes at once. If it loses all triangles, a
 *   later scan can give it others, anywhere;
 * - `Revision` (int32): the Revision in which the triangles of the region were last changed.
 *   BestScan, ScanCount and LastScan can change without it.
 *
 * Its field data are `NumberOfScans` and `Revision` (int32), and `SensorPositions` (float64, three
 * components, metres), one for each scan; 0 0 0 for a scan that has neither returns nor
 * `SensorToWorld`.
 *
 * Invalid input gives an error message that says what is expected, the error code
 * vtkErrorCode::UserError, and an empty output. Invalid are: maps without scans or scans without
 * maps; a map without `PatchId`, with cells that are no triangles, or with a `LargestDeviation`
 * above MaximumError; a scan that vtkLMS3DSurfaceReconstructionFilter refuses; a pose that is not a
 * rotation and a translation; beams or triangles farther than 6e8 times MaximumError from the
 * origin. The filter reports an error once, until a property or an input changes. An abort
 * (SetAbortExecute) leaves the output empty and discards all scans: as soon as AbortExecute is off
 * again, the next update begins a new map. The output is the same to the bit for any
 * NumberOfThreads.
 *
 * @sa
 * vtkLMS3DSurfaceReconstructionFilter vtkLMS3DScanFilter
 */
#ifndef vtkLMS3DMapFusion_h
#define vtkLMS3DMapFusion_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class VTKLMS3DFILTERS_EXPORT vtkLMS3DMapFusion : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DMapFusion* New();
  vtkTypeMacro(vtkLMS3DMapFusion, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The second input, the scans. The first input, the local maps, has VTK's usual methods.
   */
  void SetScanConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void AddScanConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }
  void SetScanData(vtkDataObject* scan) { this->SetInputDataObject(1, scan); }
  void AddScanData(vtkDataObject* scan) { this->AddInputDataObject(1, scan); }
  ///@}

  ///@{
  /**
   * Remove all connections of an input.
   */
  void RemoveAllMaps() { this->RemoveAllInputConnections(0); }
  void RemoveAllScans() { this->RemoveAllInputConnections(1); }
  ///@}

  /**
   * Adds the scan of one pose and its local map. Returns false, with an error, if they are invalid
   * or if the filter has connections; the map is then as before. The data may be changed or deleted
   * afterwards. The next update shows the map.
   */
  bool AddScan(vtkPolyData* map, vtkPolyData* scan);

  /**
   * Begins a new map without scans.
   */
  void Reset();

  ///@{
  /**
   * The error bound of the map, metres, above 0. Other values are an error. The local maps must
   * have been made with this MaximumError or a smaller one. A change begins a new map; scans of
   * AddScan have then to be added again. The default is 0.01.
   */
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * Whether the filter keeps the ranges of all scans, four bytes for each beam, so that what a
   * later scan guesses between its returns is checked against the beams of earlier ones, and planes
   * are fitted to few returns of several scans. Otherwise such a guess may block beams of earlier
   * scans, about one in a hundred in the room of the tests, the map has more triangles, and the
   * memory is that of the map and its rasters alone, about 6 kB for each block of 64 x 64 cells. On
   * by default.
   */
  vtkSetMacro(KeepReturns, bool);
  vtkGetMacro(KeepReturns, bool);
  vtkBooleanMacro(KeepReturns, bool);
  ///@}

  ///@{
  /**
   * Whether surface with returns is taken out if beams of a later scan pass through it: things that
   * were moved. Off, the default, is for static scenes: on, up to one return in a hundred goes in
   * the static room of the tests, too.
   */
  vtkSetMacro(ForgetSeenThrough, bool);
  vtkGetMacro(ForgetSeenThrough, bool);
  vtkBooleanMacro(ForgetSeenThrough, bool);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024. 0, the default, uses all cores. The output does not depend on
   * it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * The number of scans in the map.
   */
  int GetNumberOfScans() const;

  /**
   * A number that grows with each scan that is added. Reset does not lower it.
   */
  int GetRevision() const;

  /**
   * Fills `delta` with the triangles of all regions that changed after a Revision, as the output
   * has them, and with the field data `ChangedRegions` (int32), their RegionIds. A client that has
   * the map of this Revision removes the triangles of these regions and adds the triangles of
   * `delta`. Regions that have no triangles any more are in `ChangedRegions` alone. After a Reset,
   * all regions of the map before it are among the changed ones.
   */
  void GetChanges(int sinceRevision, vtkPolyData* delta);

protected:
  vtkLMS3DMapFusion();
  ~vtkLMS3DMapFusion() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DMapFusion(const vtkLMS3DMapFusion&) = delete;
  void operator=(const vtkLMS3DMapFusion&) = delete;

  double MaximumError = 0.01;
  bool KeepReturns = true;
  bool ForgetSeenThrough = false;
  int NumberOfThreads = 0;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
