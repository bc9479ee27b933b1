// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DScanFilter
 * @brief   scans a surface with a simulated 3D laser range finder
 *
 * vtkLMS3DScanFilter simulates a SICK LMS 200, a laser that measures in a plane, turned about the
 * vertical on a rotating support (Bedkowski, Kretkiewicz and Maslowski, "3D laser range finder
 * simulation based on rotated LMS SICK 200"). It casts one beam for each elevation alpha of the fan
 * and each platform angle beta, and returns where they meet the input's surface:
 *
 *     d(alpha, beta) = (cos(alpha) cos(beta), -cos(alpha) sin(beta), sin(alpha))
 *
 * in the sensor frame, right-handed with z up (the paper's section 2.1); beta turns clockwise seen
 * from above. The sensor is ideal: a beam is a ray without width, and its range has no noise.
 *
 * The input is a vtkPolyData (polygons and strips; vertices and lines have no surface), any other
 * data set (its outer surface), or a composite of them. Both sides of a surface return. Units are
 * metres and degrees.
 *
 * Output 0, the scan, is a vtkPolyData in world coordinates with one vertex for each return,
 * ordered by turn, then beam. Its point data:
 * - `Range` (float64): the distance from the sensor, metres;
 * - `Alpha`, `Beta` (float32): the beam's angles, degrees;
 * - `BeamId` (int32): turn * AlphaResolution + beam;
 * - `CellId` (vtkIdType): the input's cell that was hit: its global id where all cells have one
 *   (vtkDataSetAttributes::GetGlobalIds), else its number; cells of a composite are numbered
 *   through, leaf after leaf.
 *
 * Its field data: `AlphaAngles` and `BetaAngles` (float64, degrees), the axes of the grid, and
 * `SensorToWorld` (16 float64), the pose as a row-major matrix.
 *
 * Output 1, the range image, is a vtkImageData of AlphaResolution x BetaResolution points with the
 * array `Range` (float64), NaN where a beam gave no return. Its axes are the angles in degrees.
 *
 * Input 1, optional, is a trajectory: a vtkPolyData whose points are the poses of a moving sensor,
 * one time step each, in place of Position. With one polyline the poses are its points in its
 * order, without lines all points in theirs. The orientation of a pose is
 * - that of the point array `Orientation` where there is one: quaternions w, x, y, z, of any length
 *   but 0, which turn the sensor frame into the world's;
 * - else, with a polyline, that of a vehicle: the sensor's x axis points from the pose before to the
 *   one after, its y axis is level, to the left. Where the sensor stands still it keeps its axes (at
 *   the start, the world's); where it moves straight up or down it keeps its y axis;
 * - else the property Orientation.
 *
 * The time of a pose is that of the point array `Time` where there is one (finite, each later than
 * the one before), else 0, 1, 2 and so on. The filter reports these as TIME_STEPS and TIME_RANGE, and
 * gives the scan of the last pose whose time has come: between two steps that of the earlier, before
 * the first that of the first, as when no time is asked for. DATA_TIME_STEP of the outputs is the
 * pose's own time. A scene that changes with time is asked for the same time.
 *
 * With a Controller of several processes, as in ParaView under MPI, each casts against its own piece
 * of the scene, and the nearest return wins. The first process has the scan, the others an empty
 * one; each has its block of the range image, as VTK spreads images. For EXACT, ANGLE_SUM and
 * MOLLER_TRUMBORE the scan is that of the whole scene to the bit, however it is spread, provided
 * that no cell was cut and that all have global ids, as ParaView's RedistributeDataSet generates:
 * of hits at the same range that in the cell with the smallest number is returned. Without ids
 * cells are numbered through, process after process, so that CellId, and which of several hits at
 * the same range is returned, depend on how the scene is spread. The other methods round each piece
 * differently. The trajectory is that of the first process.
 *
 * The acceleration structure (Embree) is built when the input or IntersectionMethod changes, not
 * when the pose or the angles do. The outputs are the same to the bit for any NumberOfThreads.
 *
 * Bad input and bad properties give an error that says what to do, the error code
 * vtkErrorCode::UserError, and empty outputs: an input without polygons, a range that is empty
 * or out of its limits, more than 2^31 - 1 beams, a trajectory without points, with several lines
 * or with bad positions, quaternions or times. Cells with a point that is not finite or beyond
 * 1e18 m, and polygons that cross themselves, are left out, with one warning that counts them.
 *
 * What a scene may be, for the method EXACT (IntersectionMethods tells of the others): triangles
 * without area are never hit. Of faces at the same place either is returned, the same one each
 * time. Where triangles meet in a T, rounding of the vertex on the edge leaves a gap of some 1e-16
 * of the scene's size, and a beam that runs exactly there sees through it. A sensor on a face, an
 * edge or a vertex does not see what it stands on, since only ranges above 0 count; one that
 * rounding puts beside the face sees it, at a range as small as that rounding. Sizes of 1e-6 to
 * 1e7 m and offsets up to 1e7 m cost no accuracy beyond the rounding of the coordinates themselves;
 * below 1e-100 m beams may be lost. A scan takes longer where triangles are smaller than a millionth
 * of the scene, unless no more than 16 of them make it so large: an endless floor costs nothing. It
 * takes longest, as long as a test of every triangle for every beam, where the sensor is farther
 * from the scene than a million times its size.
 *
 * Memory, beside the input and the outputs: for EXACT and FAST 24 bytes a point and 12 a triangle
 * (20 where cells are not all triangles) and Embree's structure; 4 bytes a beam, of several
 * processes 20 more. The memory of an output that nobody looks at any more is kept for the next
 * scan.
 *
 * @sa
 * vtkLMS3DSurfaceReconstructionFilter vtkVRMLImporterSource
 */
#ifndef vtkLMS3DScanFilter_h
#define vtkLMS3DScanFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class lms3dProcesses;
class vtkImageData;
class vtkMultiProcessController;
struct lms3dPose;
struct lms3dRangeLimits;

class VTKLMS3DFILTERS_EXPORT vtkLMS3DScanFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DScanFilter* New();
  vtkTypeMacro(vtkLMS3DScanFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The sensor's position in the scene, metres. Any finite numbers up to 1e18; the default is
   * (0, 0, 0).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * The sensor's orientation in the scene as angles about x, y and z, degrees, applied as those of
   * vtkProp3D: RotateZ, RotateX, RotateY. Any finite numbers; the default is (0, 0, 0), the fan's
   * axis up along z.
   */
  vtkSetVector3Macro(Orientation, double);
  vtkGetVector3Macro(Orientation, double);
  ///@}

  ///@{
  /**
   * First and last elevation of the fan, degrees, both included. Increasing, within -90 to 90; the
   * default is -90 to 90, the LMS 200's scanning angle of 180 degrees.
   */
  vtkSetVector2Macro(AlphaRange, double);
  vtkGetVector2Macro(AlphaRange, double);
  ///@}

  ///@{
  /**
   * The number of beams in the fan, at least 1 (which takes the start of AlphaRange alone). The
   * default is 361, steps of half a degree over the default range.
   */
  vtkSetMacro(AlphaResolution, int);
  vtkGetMacro(AlphaResolution, int);
  ///@}

  ///@{
  /**
   * First and last platform angle, degrees. Increasing by at most 360, but for rounding up to 1e-6.
   * Both are included, except that the end of a full circle is left out, being its start again. The
   * default is 0 to 360.
   */
  vtkSetVector2Macro(BetaRange, double);
  vtkGetVector2Macro(BetaRange, double);
  ///@}

  ///@{
  /**
   * The number of turns, at least 1 (which takes the start of BetaRange alone). The default is 360,
   * steps of one degree over the default range.
   */
  vtkSetMacro(BetaResolution, int);
  vtkGetMacro(BetaResolution, int);
  ///@}

  ///@{
  /**
   * A beam whose nearest surface is nearer than this gives no return, metres. From 0 up to
   * MaximumRange; the default is 0.
   */
  vtkSetMacro(MinimumRange, double);
  vtkGetMacro(MinimumRange, double);
  ///@}

  ///@{
  /**
   * A beam that meets no surface up to this range gives no return, metres. Above 0, may be
   * infinite; the default is 80, the reach of the LMS 200.
   */
  vtkSetMacro(MaximumRange, double);
  vtkGetMacro(MaximumRange, double);
  ///@}

  /**
   * How a beam finds the surface. Whatever the method, outputs do not depend on the number of
   * threads, and only ranges above 0 count.
   *
   * EXACT: Embree finds candidates; a test in double with error bounds, and without rounding where
   * a bound leaves a sign open (Shewchuk 1997), decides. Exact is the answer for vertices and
   * Position as they are in double, and for the beam's direction as it is rounded (its length is 1
   * to about 3e-16). Triangles are closed, so that no beam passes between two that share an edge or
   * a vertex; a beam within a triangle's plane does not hit it. A range is right to 3 units in its
   * last place, however narrow the triangle. (Where two surfaces lie within 1e-13 of their range of
   * one another, it may be that of either.)
   *
   * FAST: Embree's single precision decides, and the range is measured in double in the plane of
   * the triangle that it found, to about 13 digits; at a grazing angle to as many fewer as the
   * cosine of the incidence has zeros. For previews and live use: a beam within about 1e-6 of the
   * scene's size from an edge may be given to the wrong side of it. Where poses and scenes lie on a
   * common grid, so that beams run along edges and through silhouettes, some are missed or see what
   * is behind, as are beams near a needle that points at the sensor, a few of those within 1e-4
   * radians of a surface, and one in a thousand of those aimed at edges with a surface behind. A
   * sensor on a surface gets no return from the half space that it looks at through it, or ranges
   * as small as rounding. Triangles without area are never hit.
   *
   * The others are for comparison, and tens to thousands of times slower.
   *
   * ANGLE_SUM: the founding paper's section 2.4, by brute force: the intersection with the
   * triangle's plane lies inside where the angles between its corners sum to 2 pi, within 1e-6, or
   * where it is nearer to a corner than 1e-9 of the range. So a beam that passes a triangle's edge
   * by less than about 1e-7 of its size hits it, and a needle narrower than that is a line that
   * hides what is behind. As printed, the method mirrors planes through the origin, returns
   * surfaces behind the sensor, takes a parallel plane for a range of 0, and compares with 2 pi
   * exactly, which loses most beams.
   *
   * MOLLER_TRUMBORE: the textbook test (Moeller and Trumbore 1997) in double, by brute force.
   * Triangles that share an edge do not round alike, so that beams exactly at edges and vertices
   * may pass between them: of those aimed at an icosphere's, one in ten or fifteen.
   *
   * STATIC_CELL_LOCATOR: vtkStaticCellLocator with a tolerance of 1e-9 m, by which a beam may pass
   * a triangle and still hit it; a scene must be much larger than that, and where coordinates reach
   * 1e7 m, whose rounding is as large, some beams are lost at edges. Of triangles within the
   * tolerance of one another any may be returned, and a sensor within it of a surface may miss
   * what is behind.
   *
   * With ANGLE_SUM, MOLLER_TRUMBORE and STATIC_CELL_LOCATOR, as with EXACT, triangles without area
   * and those on whose plane the sensor stands are never hit, and hide nothing; ranges are right to
   * about 13 digits (ANGLE_SUM: 9, where the scene is far away), fewer at a grazing angle.
   */
  enum IntersectionMethods
  {
    EXACT = 0,
    FAST = 1,
    ANGLE_SUM = 2,
    MOLLER_TRUMBORE = 3,
    STATIC_CELL_LOCATOR = 4
  };

  ///@{
  /**
   * How a beam finds the surface, one of IntersectionMethods; the default is EXACT. A change builds
   * the acceleration structure anew.
   */
  vtkSetClampMacro(IntersectionMethod, int, EXACT, GetNumberOfIntersectionMethods() - 1);
  vtkGetMacro(IntersectionMethod, int);
  void SetIntersectionMethodToExact() { this->SetIntersectionMethod(EXACT); }
  void SetIntersectionMethodToFast() { this->SetIntersectionMethod(FAST); }
  void SetIntersectionMethodToAngleSum() { this->SetIntersectionMethod(ANGLE_SUM); }
  void SetIntersectionMethodToMollerTrumbore() { this->SetIntersectionMethod(MOLLER_TRUMBORE); }
  void SetIntersectionMethodToStaticCellLocator()
  {
    this->SetIntersectionMethod(STATIC_CELL_LOCATOR);
  }
  const char* GetIntersectionMethodAsString() const;
  ///@}

  ///@{
  /**
   * The methods by number, from 0, and by name as in the setters above ("AngleSum"), for those who
   * offer all of them. The name of a number that is none is null.
   */
  static int GetNumberOfIntersectionMethods();
  static const char* GetIntersectionMethodName(int method);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024; the default, 0, takes all cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The trajectory, input 1; none by default. A vtkPolyData whose points are the sensor's positions,
   * as the class tells.
   */
  void SetTrajectoryConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetTrajectoryData(vtkDataObject* poses) { this->SetInputDataObject(1, poses); }
  ///@}

  ///@{
  /**
   * The processes that scan together; null, or a controller of one process, for this one alone. The
   * default is the global controller at the time the filter is made. All of them must update the
   * filter, with the same properties.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * The time when the acceleration structure was last built, 0 before the first. Tells whether an
   * update had to build.
   */
  vtkMTimeType GetBuildTime() const;

  /**
   * The second output.
   */
  vtkImageData* GetRangeImage();

protected:
  vtkLMS3DScanFilter();
  ~vtkLMS3DScanFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DScanFilter(const vtkLMS3DScanFilter&) = delete;
  void operator=(const vtkLMS3DScanFilter&) = delete;

  double Position[3] = { 0.0, 0.0, 0.0 };
  double Orientation[3] = { 0.0, 0.0, 0.0 };
  double AlphaRange[2] = { -90.0, 90.0 };
  int AlphaResolution = 361;
  double BetaRange[2] = { 0.0, 360.0 };
  int BetaResolution = 360;
  double MinimumRange = 0.0;
  double MaximumRange = 80.0;
  int IntersectionMethod = EXACT;
  int NumberOfThreads = 0;

  // Empty where all properties are good.
  std::string GetPropertyError() const;
  lms3dRangeLimits GetLimits() const;

  // Sets the time steps of both outputs; false where the trajectory is of another kind.
  bool PublishTimeSteps(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  void Scan(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  void Build(vtkDataObject* scene);
  void CheckScene(bool hasTriangles) const;
  bool CastAlone(const lms3dPose& pose, vtkPolyData* scan, vtkImageData* image);
  bool CastInParallel(const lms3dProcesses& processes, const lms3dPose& pose, int ghostLevels,
    vtkPolyData* scan, vtkImageData* image);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
