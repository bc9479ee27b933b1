// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DMapComparison
 * @brief   measures how well a local map shows the scene that was scanned
 *
 * vtkLMS3DMapComparison compares a map with the scene itself. The map may come from
 * vtkLMS3DSurfaceReconstructionFilter or from any other method. The filter measures both
 * directions: the distance of the map from the scene, and the distance of the visible scene from
 * the map. The first alone would favour a map that leaves out difficult parts, the second alone a
 * map that fills the room.
 *
 * Both surfaces are sampled evenly by area. Sampling at vertices would be misleading: the vertices
 * of a map are returns, so they lie on the scene even if the triangles between them do not. Each
 * distance is the Euclidean distance to the nearest point of the other surface. A point of the
 * scene is visible if the sensor's beams cover its direction, its range lies within MinimumRange
 * and MaximumRange, and no other part of the scene hides it.
 *
 * Inputs:
 * - 0, the map: a vtkPolyData with polygons or strips;
 * - 1, the scene: any input that vtkLMS3DScanFilter accepts, in the same coordinates;
 * - 2, the scan that the map was made from. It is optional if the map carries the scan's field data
 *   `SensorToWorld`, `AlphaAngles` and `BetaAngles`, and, if not default, `Mounting`, `AxisOffset`
 *   and `TurnRate`, as maps of our filter do.
 *
 * The comparison understands all mountings of vtkLMS3DScanFilter. With an AxisOffset, visibility,
 * ranges and the side of a triangle count from the mirror's centre at the platform angle whose beam
 * leads to the point. If two angles do, on either side of the axis, a point is visible if either
 * beam sees it. With a TurnRate, the ends of an open scan, where the interlaced beams of a fan
 * begin and end one after the other, are not covered.
 *
 * Output 0 is the map with two more arrays: the point data `Error` (float64, metres), the distance
 * of each vertex from the scene, and the cell data `LargestError`, the largest distance among a
 * cell's vertices and samples (NaN if a cell has no surface). The getters return the results. The
 * field data of output 0 hold the same numbers, as float64:
 * - `MapToScene`, `SceneToMap` (metres) and `NormalError` (degrees): each the mean, the root mean
 *   square, the 95th percentile and the maximum;
 * - `Correctness`, `Completeness` and `FScore`;
 * - `AreaInFreeSpace`, `ClosedGapAreaInFreeSpace`, `MapArea`, `VisibleArea` (square metres) and
 *   `MapTriangles`;
 * - if the scan has returns: `ReturnsWithinTolerance` and `LargestReturnDistance` (metres).
 *
 * Output 1 is a vtkPolyData of vertices: the samples of the visible scene, with the point data
 * `Error` (float64, metres), the distance from the map. It shows what the map lacks.
 *
 * The samples are the same in every run, and the results are the same to the bit for any
 * NumberOfThreads. Distances are computed in double; Embree only finds the triangles nearby.
 *
 * Invalid input gives an error that says what to do, the error code vtkErrorCode::UserError, and
 * empty outputs: a map or a scene without triangles, a missing pose, a sensor that sees nothing of
 * the scene. The filter reports an error once, until a property or an input changes. Cells with a
 * point that is not finite are skipped, with a warning. After an abort the outputs are empty, and
 * the next update compares again.
 *
 * With a Controller of several processes the process that has the map compares. It needs the whole
 * scene: if more than one process has a part of the scene, every process reports an error. The
 * other processes have empty outputs, and their getters return NaN.
 *
 * @sa
 * vtkLMS3DSurfaceReconstructionFilter vtkLMS3DScanFilter
 */
#ifndef vtkLMS3DMapComparison_h
#define vtkLMS3DMapComparison_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <cmath> // For NAN
#include <memory> // For std::unique_ptr

class vtkMultiProcessController;

class VTKLMS3DFILTERS_EXPORT vtkLMS3DMapComparison : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DMapComparison* New();
  vtkTypeMacro(vtkLMS3DMapComparison, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The second input, the scene, and the third, the scan.
   */
  void SetSceneConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSceneData(vtkDataObject* scene) { this->SetInputDataObject(1, scene); }
  void SetScanConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetScanData(vtkDataObject* scan) { this->SetInputDataObject(2, scan); }
  ///@}

  ///@{
  /**
   * The largest distance that counts as correct, metres. At least 0; the default is 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The number of samples of the map. The visible scene gets about as many; fewer if the sensor
   * sees less than 1/32 of the scene. From 1 to 10,000,000; the default is 200,000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 10000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * The sensor's range limits, metres: points of the scene nearer than the minimum or farther than
   * the maximum are not visible. 0 <= minimum <= maximum, and the maximum is above 0; it may be
   * infinite. The defaults are 0 and 80.
   */
  vtkSetMacro(MinimumRange, double);
  vtkGetMacro(MinimumRange, double);
  vtkSetMacro(MaximumRange, double);
  vtkGetMacro(MaximumRange, double);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024. The default, 0, uses all cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The processes that share the inputs. Null, or a controller of one process: this process
   * compares alone. The default is the global controller when the filter is created. All processes
   * must update the filter, with the same properties.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /**
   * The distance of the map's samples from the scene, metres: the mean, the root mean square, the
   * smallest distance that 95 % of the samples do not exceed, and the maximum.
   *
   * All results, here and below, are results of the last update. They are NaN before the first
   * update, after an error or an abort, and in a process that does not compare.
   */
  vtkGetMacro(MapToSceneMean, double);
  vtkGetMacro(MapToSceneRMS, double);
  vtkGetMacro(MapToScenePercentile95, double);
  vtkGetMacro(MapToSceneMaximum, double);
  ///@}

  ///@{
  /**
   * The distance of the visible scene's samples from the map, metres.
   */
  vtkGetMacro(SceneToMapMean, double);
  vtkGetMacro(SceneToMapRMS, double);
  vtkGetMacro(SceneToMapPercentile95, double);
  vtkGetMacro(SceneToMapMaximum, double);
  ///@}

  ///@{
  /**
   * The angle between the planes of the map's triangle and of the nearest triangle of the scene,
   * degrees, 0 to 90. The orientation of the scene's faces does not matter. If a triangle of the
   * map faces away from the sensor, by the right-hand rule, 180 minus this angle.
   */
  vtkGetMacro(NormalErrorMean, double);
  vtkGetMacro(NormalErrorRMS, double);
  vtkGetMacro(NormalErrorPercentile95, double);
  vtkGetMacro(NormalErrorMaximum, double);
  ///@}

  ///@{
  /**
   * Correctness: the share of the map, 0 to 1, within Tolerance of the scene. Completeness: the
   * share of the visible scene within Tolerance of the map. FScore: their harmonic mean (Knapitsch
   * et al. 2017, "Tanks and Temples").
   */
  vtkGetMacro(Correctness, double);
  vtkGetMacro(Completeness, double);
  vtkGetMacro(FScore, double);
  ///@}

  ///@{
  /**
   * The area of the map in space that the sensor has seen to be empty, square metres: farther than
   * Tolerance from the scene, and in front of the scene by more than Tolerance. Where the map
   * closes gaps between returns, beams have seen nothing. So the area there, around the beams of
   * the map's field data `ClosedBeamIds`, counts as ClosedGapAreaInFreeSpace instead.
   */
  vtkGetMacro(AreaInFreeSpace, double);
  vtkGetMacro(ClosedGapAreaInFreeSpace, double);
  ///@}

  ///@{
  /**
   * The area of the map and of the visible scene, square metres.
   */
  vtkGetMacro(MapArea, double);
  vtkGetMacro(VisibleArea, double);
  ///@}

  /**
   * The number of the map's triangles that have an area; 0 where the other results are NaN.
   */
  vtkGetMacro(MapTriangles, vtkIdType);

  ///@{
  /**
   * The share of the scan's returns, 0 to 1, within Tolerance of the map, and the largest distance
   * of a return from the map, metres. NaN also without a scan, or if the scan has no returns.
   */
  vtkGetMacro(ReturnsWithinTolerance, double);
  vtkGetMacro(LargestReturnDistance, double);
  ///@}

protected:
  vtkLMS3DMapComparison();
  ~vtkLMS3DMapComparison() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DMapComparison(const vtkLMS3DMapComparison&) = delete;
  void operator=(const vtkLMS3DMapComparison&) = delete;

  double Tolerance = 0.01;
  int NumberOfSamples = 200000;
  double MinimumRange = 0.0;
  double MaximumRange = 80.0;
  int NumberOfThreads = 0;

  double MapToSceneMean = NAN;
  double MapToSceneRMS = NAN;
  double MapToScenePercentile95 = NAN;
  double MapToSceneMaximum = NAN;
  double SceneToMapMean = NAN;
  double SceneToMapRMS = NAN;
  double SceneToMapPercentile95 = NAN;
  double SceneToMapMaximum = NAN;
  double NormalErrorMean = NAN;
  double NormalErrorRMS = NAN;
  double NormalErrorPercentile95 = NAN;
  double NormalErrorMaximum = NAN;
  double Correctness = NAN;
  double Completeness = NAN;
  double FScore = NAN;
  double AreaInFreeSpace = NAN;
  double ClosedGapAreaInFreeSpace = NAN;
  double MapArea = NAN;
  double VisibleArea = NAN;
  vtkIdType MapTriangles = 0;
  double ReturnsWithinTolerance = NAN;
  double LargestReturnDistance = NAN;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
