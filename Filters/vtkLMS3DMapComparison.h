// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DMapComparison
 * @brief   measures how well a local map shows the scene that was scanned
 *
 * vtkLMS3DMapComparison compares a map, made by vtkLMS3DSurfaceReconstructionFilter or by any other
 * method, with the scene itself, in both directions: how far the map is from the scene, and how far
 * the scene, as much of it as the sensor saw, is from the map. The first alone would praise a map
 * that leaves out what is difficult, the second one that fills the room.
 *
 * Both surfaces are sampled evenly by area, not at their vertices (those of a map are returns, so
 * they lie on the scene however badly the triangles between them do), and each distance is the
 * Euclidean one to the nearest point of the other surface. A point of the scene is visible where
 * the sensor's beams cover its direction, its range lies within MinimumRange and MaximumRange, and
 * no other part of the scene hides it.
 *
 * Inputs:
 * - 0, the map: a vtkPolyData with polygons or strips;
 * - 1, the scene: what vtkLMS3DScanFilter takes for its input, in the same coordinates;
 * - 2, the scan that the map was made of; optional where the map carries the scan's field data
 *   `SensorToWorld`, `AlphaAngles` and `BetaAngles`, as that of our filter does.
 *
 * Output 0 is the map with two arrays more: the point data `Error` (float64, metres), the distance
 * of each vertex from the scene, and the cell data `LargestError`, the largest of a cell's vertices
 * and samples (NaN where a cell has no surface). Its field data hold the results, each float64:
 * - `MapToScene`, `SceneToMap` (metres) and `NormalError` (degrees): each the mean, the root mean
 *   square, the 95th percentile and the maximum;
 * - `Correctness`: the share of the map, 0 to 1, within Tolerance of the scene, `Completeness`: the
 *   share of the visible scene within Tolerance of the map, and `FScore`, their harmonic mean
 *   (Knapitsch et al. 2017, "Tanks and Temples");
 * - `AreaInFreeSpace` (square metres): the part of the map that is farther than Tolerance from the
 *   scene, and as much in front of it: where the sensor has seen that there is nothing;
 * - `MapArea`, `VisibleArea` (square metres) and `MapTriangles`;
 * - with a scan that has returns: `ReturnsWithinTolerance`, the share of its returns within
 *   Tolerance of the map, and `LargestReturnDistance` (metres), that of the return farthest from
 *   it.
 *
 * The normal error is the angle between the planes of a map's triangle and of the scene's nearest
 * one, 0 to 90 degrees; which side of the scene's faces is the outer one is not asked. Where a
 * triangle of the map turns its back to the sensor, by the right-hand rule, it is 180 less that.
 *
 * Output 1 is a vtkPolyData of vertices: the samples of the visible scene, with the point data
 * `Error` (float64, metres), the distance from the map. It shows what the map lacks.
 *
 * The samples are the same each time, and the results to the bit for any NumberOfThreads. Distances
 * are computed in double; Embree only tells which triangles are near.
 *
 * Bad input gives an error that says what to do, the error code vtkErrorCode::UserError, and empty
 * outputs: a map or a scene without triangles, no pose, a sensor that sees nothing of the scene.
 * Cells with a point that is not finite are left out, with a warning. Of several processes the one
 * with the map compares; a scene that is spread over more than one is refused.
 *
 * @sa
 * vtkLMS3DSurfaceReconstructionFilter vtkLMS3DScanFilter
 */
#ifndef vtkLMS3DMapComparison_h
#define vtkLMS3DMapComparison_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

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
   * How near counts as right, metres. At least 0; the default is 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The number of samples of the map, and, nearly, of the visible scene: where the sensor sees less
   * than a 32nd of the scene they are fewer. From 1 to 10,000,000; the default is 200,000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 10000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * What of the scene is nearer, or farther, than this is not visible, metres: those of the scan.
   * 0 <= minimum <= maximum; the maximum may be infinite. The defaults are 0 and 80.
   */
  vtkSetMacro(MinimumRange, double);
  vtkGetMacro(MinimumRange, double);
  vtkSetMacro(MaximumRange, double);
  vtkGetMacro(MaximumRange, double);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024; the default, 0, takes all cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkLMS3DMapComparison();
  ~vtkLMS3DMapComparison() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DMapComparison(const vtkLMS3DMapComparison&) = delete;
  void operator=(const vtkLMS3DMapComparison&) = delete;

  void CheckProperties() const;
  void Compare(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  double Tolerance = 0.01;
  int NumberOfSamples = 200000;
  double MinimumRange = 0.0;
  double MaximumRange = 80.0;
  int NumberOfThreads = 0;
};

#endif
