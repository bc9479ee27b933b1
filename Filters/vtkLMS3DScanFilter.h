// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DScanFilter
 * @brief   scans a surface with a simulated 3D laser range finder
 *
 * vtkLMS3DScanFilter simulates a SICK LMS 200 on a rotating support (Bedkowski, Kretkiewicz and
 * Maslowski, "3D laser range finder simulation based on rotated LMS SICK 200"). The LMS 200
 * measures a fan of beams in one plane; the support turns this plane about the vertical. The filter
 * casts one beam for each elevation alpha in the fan and each platform angle beta, and returns the
 * points where the beams hit the input's surface. In the sensor frame, which is right-handed with z
 * up, a beam has the direction
 *
 *     d(alpha, beta) = (cos(alpha) cos(beta), -cos(alpha) sin(beta), sin(alpha))
 *
 * (section 2.1 of the paper). Beta turns clockwise, seen from above. (See Mounting for other
 * supports.) By default the sensor is ideal: a beam has no width, every surface returns it, and the
 * sensor rests during a scan. Each effect of a real device is a property. (vtkLMS3DRangeErrorFilter
 * adds the errors of ranges.) Units are metres, degrees and seconds.
 *
 * @par Input 0, the scene
 * A vtkPolyData, any other data set, or a composite of data sets. The filter scans polygons and
 * triangle strips of a vtkPolyData (vertices and lines have no surface), and the outer surface of
 * any other data set. Both sides of a surface give returns. Cells that vtkGhostType marks as
 * HIDDENCELL are skipped; duplicate cells are scanned like all others.
 *
 * @par Output 0, the scan
 * A vtkPolyData in world coordinates with one vertex for each return, ordered by turn, then by
 * beam. Its point data:
 * - `Range` (float64): the distance from the sensor, metres;
 * - `Alpha`, `Beta` (float32): the angles of the beam, degrees (with TurnRate, Beta is the angle
 *   that the platform has reached when the beam leaves);
 * - `BeamId` (int32): turn * AlphaResolution + beam;
 * - `CellId` (vtkIdType): the cell of the input that the beam hit. If all cells have global ids
 *   (vtkDataSetAttributes::GetGlobalIds), it is the global id, otherwise the number of the cell.
 *   The cells of a composite are numbered consecutively over all leaves.
 * @par
 * Its field data: `AlphaAngles` and `BetaAngles` (float64, degrees) are the axes of the grid of
 * beams; `SensorToWorld` (16 float64) is the pose as a row-major matrix. `Mounting`, `AxisOffset`
 * and `TurnRate` (float64) are there if they differ from their defaults. `TurnToWorld` (16 float64
 * for each turn) is there with MotionDuringScan and a trajectory. ComputeStatus adds `Status`.
 *
 * @par Surface attributes
 * If SurfaceAttributes is on, the scan has more point data, in this order:
 * - `Normals` (float32, 3 components, the active normals): the unit normal of the triangle that the
 *   beam hit, towards the sensor. Rounding never turns it to the other side. (Only with
 *   FAST a beam can hit a triangle whose plane contains the sensor. Its normal is on the side from
 *   which its corners are counter-clockwise.)
 * - `Incidence` (float32): the angle between the beam and the normal, 0 to 90 degrees. 0 means that
 *   the beam is perpendicular to the surface. ComputeIncidence adds only this array.
 * - `Intensity` (float32), if ComputeIntensity is on, also without SurfaceAttributes.
 * - The cell arrays of the scene, with the names and types that they have there: the value of the
 *   cell that CellId names. A scene from vtkVRMLImporterSource has `ShapeId` and `Color`, and the
 *   names of the shapes in the field data `ShapeNames`.
 * @par
 * These cell arrays are left out: vtkGhostType, the global ids (CellId has them), arrays without a
 * name or with the name of an array of the scan, and arrays that not all data sets of a composite
 * have with the same type and number of components. The range image stays the same; BeamId is the
 * index of a return in it.
 *
 * @par What the device detects
 * RangeAtTenPercent removes returns of surfaces that are too dark, too oblique or too far. It comes
 * after MinimumRange and MaximumRange. A surface that the device does not detect hides what lies
 * behind it. ComputeStatus says why a beam gave no return.
 *
 * @par Output 1, the range image
 * A vtkImageData of AlphaResolution x BetaResolution points with the array `Range` (float64,
 * metres), which is NaN if the beam gave no return, and, if ComputeStatus is on, `Status`. The axes
 * of the image are the angles in degrees. If all beams give returns, the arrays `Range` of both
 * outputs share their values, except with several processes: copy one before you change them.
 *
 * @par Input 1, the trajectory
 * Optional: a vtkPolyData whose points are the poses of a moving sensor, one for each time step.
 * They replace Position. If the data has one polyline, the poses are the points of the polyline in
 * its order; if it has no lines, they are all points in their own order. The orientation of a pose
 * comes from the first of these that applies:
 * - The point array `Orientation`: quaternions w, x, y, z, of any length except 0, that rotate the
 *   sensor frame to the world frame.
 * - The polyline: the sensor moves like a vehicle. Its x axis points from the previous pose to the
 *   next, and its y axis is level and points to the left. If the sensor stands still, it keeps its
 *   axes; at the start they are the world's. If it moves straight up or down, it keeps its y axis.
 * - The property Orientation.
 * @par
 * The time of a pose is its value in the point array `Time`. Times must be finite, and each must be
 * later than the one before. Without this array the times are 0, 1, 2 and so on. The filter
 * publishes the times as TIME_STEPS and TIME_RANGE. It scans from the last pose that is not later
 * than the requested time; from the first pose if the requested time is earlier than all poses, or
 * if no time is requested. DATA_TIME_STEP of the outputs is the time of the pose. A scene that
 * changes with time receives the requested time as well.
 *
 * @par Several processes
 * If the Controller has several processes, as in ParaView under MPI, each process casts beams
 * against its own piece of the scene, and the nearest return wins. The first process has the scan,
 * and all others have an empty one with the same arrays. Each process has its block of the range
 * image, as VTK distributes images. All processes use the trajectory of the first.
 * @par
 * With EXACT, ANGLE_SUM and MOLLER_TRUMBORE the scan is the same to the bit for every distribution
 * of the scene, provided that no cell was cut and that all cells have global ids
 * (Documentation/parallel.md).
 * @par
 * Surface attributes, Incidence, Intensity and the reflectance come from the process whose triangle
 * was hit. Each process with triangles needs the ReflectanceArray. The first process has the field
 * data `Status`, and each process has its block of it in the range image. For SurfaceAttributes, a
 * cell array must exist on all processes that have returns, or, if there is no return, on all that
 * have triangles. Arrays of vtkIdType become arrays of vtkTypeInt64.
 * @par
 * The filter warns once if the global ids show that cells are missing.
 *
 * @par Updates
 * The acceleration structure (Embree) is built again only if the scene's triangles, their cell
 * numbers or IntersectionMethod change. A new pose, new angles or a new data array on the scene do
 * not build. Building reports the first 30 % of the progress, and AbortExecute stops it. The
 * outputs of a stopped update are empty, and the next update runs again. The outputs are the same
 * to the bit for every NumberOfThreads.
 *
 * @par Errors
 * Bad input and bad properties give an error that says what to do, the error code
 * vtkErrorCode::UserError, and empty outputs. Errors are: an input without polygons; a range that
 * is empty or exceeds its limits; more than 2^31 - 1 beams; a trajectory without points, with
 * several lines, or with bad positions, quaternions or times; a ReflectanceArray that is used and
 * that a cell with a surface does not have, or has with a bad type or value. Cells with a point
 * that is not finite or exceeds 1e18 m are skipped. Polygons that cross themselves are filled with
 * triangles that can overlap or extend beyond them. One warning counts both. The filter reports an
 * error once, however often it is updated, until a property or an input changes.
 *
 * @par Robustness of EXACT
 * (See IntersectionMethods for the other methods.)
 * - Triangles without area are never hit.
 * - If faces coincide, one of them is returned, the same one each time.
 * - Where triangles meet in a T, rounding of the vertex on the edge leaves a gap of about 1e-16 of
 *   the scene's size. A beam exactly through this gap passes.
 * - A sensor exactly on a face, an edge or a vertex does not see it, because ranges must be above
 *   0. If rounding moves the sensor off the face, it sees the face at a range of about that
 *   rounding.
 * - Scenes of 1e-6 to 1e7 m at offsets up to 1e7 m lose no accuracy except by the rounding of the
 *   coordinates themselves. Below 1e-100 m, beams can be lost.
 * @par
 * A scan takes longer if triangles are smaller than a millionth of the scene, unless at most 16
 * triangles make the scene so large: an endless floor costs nothing. It takes longest, as long as a
 * test of every triangle for every beam, if the sensor is farther from the scene than a million
 * times the scene's size.
 *
 * @par Memory
 * In addition to the input and the outputs:
 * - kept for EXACT and FAST: 24 bytes for each point, 12 for each triangle (20 if some cells are
 *   not triangles), and Embree's structure;
 * - kept for EXACT: the planes of 1,024 triangles for each thread, about 76 KB;
 * - while a changed scene is compared with the last one: its points and triangles again;
 * - during a scan: 4 bytes for each beam, and 20 more with several processes;
 * - during a scan whose beams have a width: 12 bytes for each ray, and 20 more with several
 *   processes, of at most 2 million rays (or of four turns, if these have more) at once;
 * - during a scan with EXACT: 64 bytes for each triangle if the sensor is inside the sphere around
 *   the scene and the scene has at most two triangles for 16 beams, and 36 more if tiles of beams
 *   are decided at once (at most 5,000 triangles);
 * - while SurfaceAttributes are filled: 28 bytes for each return, more with global ids; with
 *   ComputeIncidence or ComputeIntensity alone, 4 bytes;
 * - with RangeAtTenPercent: 1 byte for each beam;
 * - with ComputeStatus, if some beams have no return: as much again as for the scan, and 8 bytes
 *   for each beam;
 * - kept while a ReflectanceArray is used: 8 bytes for each triangle.
 * @par
 * The memory of outputs that were released is kept for the next scan.
 *
 * @sa
 * vtkLMS3DRangeErrorFilter vtkLMS3DSurfaceReconstructionFilter vtkVRMLImporterSource
 */
#ifndef vtkLMS3DScanFilter_h
#define vtkLMS3DScanFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class vtkDoubleArray;
class vtkImageData;
class vtkMultiProcessController;
class vtkUnsignedCharArray;

class VTKLMS3DFILTERS_EXPORT vtkLMS3DScanFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DScanFilter* New();
  vtkTypeMacro(vtkLMS3DScanFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The position of the sensor in world coordinates, metres. Finite, each coordinate from -1e18 to
   * 1e18. The default is (0, 0, 0). A trajectory replaces it.
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * The orientation of the sensor: angles about x, y and z, degrees, applied like the orientation
   * of vtkProp3D: RotateZ, RotateX, RotateY. Any finite numbers. The default is (0, 0, 0): the
   * platform turns about the world's z axis. A trajectory with orientations of its own replaces it.
   */
  vtkSetVector3Macro(Orientation, double);
  vtkGetVector3Macro(Orientation, double);
  ///@}

  ///@{
  /**
   * The first and the last elevation of the fan, degrees, both included. The values must increase,
   * from -90 to 90; they may be equal if AlphaResolution is 1. The default is -90 to 90, the 180
   * degree scanning angle of the LMS 200.
   */
  vtkSetVector2Macro(AlphaRange, double);
  vtkGetVector2Macro(AlphaRange, double);
  ///@}

  ///@{
  /**
   * The number of beams in the fan, at least 1. A single beam has the first elevation of
   * AlphaRange. AlphaResolution x BetaResolution must not exceed 2^31 - 1. The default is 361,
   * steps of half a degree over the default range.
   */
  vtkSetMacro(AlphaResolution, int);
  vtkGetMacro(AlphaResolution, int);
  ///@}

  ///@{
  /**
   * The first and the last platform angle, degrees. The values must be finite and increase by at
   * most 360 (plus 1e-6 for rounding); they may be equal if BetaResolution is 1. Both are included,
   * except the end of a full circle, which would repeat its start. The default is 0 to 360.
   */
  vtkSetVector2Macro(BetaRange, double);
  vtkGetVector2Macro(BetaRange, double);
  ///@}

  ///@{
  /**
   * The number of turns, at least 1. A single turn has the first angle of BetaRange. The default is
   * 360, steps of one degree over the default range.
   */
  vtkSetMacro(BetaResolution, int);
  vtkGetMacro(BetaResolution, int);
  ///@}

  ///@{
  /**
   * The smallest range, metres. A beam gives no return if the nearest surface is nearer than this.
   * From 0 to MaximumRange, finite. The default is 0.
   */
  vtkSetMacro(MinimumRange, double);
  vtkGetMacro(MinimumRange, double);
  ///@}

  ///@{
  /**
   * The largest range, metres. A beam gives no return if it hits no surface up to this range. Above
   * 0; it may be infinite. The default is 80, the maximum range of the LMS 200.
   */
  vtkSetMacro(MaximumRange, double);
  vtkGetMacro(MaximumRange, double);
  ///@}

  /**
   * How a beam finds the surface. For every method, the outputs do not depend on the number of
   * threads, and only ranges above 0 count.
   *
   * EXACT: Embree finds candidates. Tests in single and double precision with error bounds decide;
   * if a bound leaves a sign open, exact arithmetic decides (Shewchuk 1997). The answer is exact
   * for the vertices and Position as they are in double precision, and for the direction of the
   * beam as it is rounded (its length is 1 to about 3e-16). Triangles are closed, so no beam passes
   * between two triangles that share an edge or a vertex. A beam in the plane of a triangle does
   * not hit it. A range is right to 3 units in its last place, however narrow the triangle is; in
   * ordinary scenes it is the true range, rounded to double. (Where two surfaces are closer to one
   * another than 1e-13 of their range, the range can be that of either surface.)
   *
   * FAST: Embree's single precision decides. The range is then computed in double precision in the
   * plane of the triangle that Embree found, to about 13 digits; at a grazing angle as many digits
   * are lost as the cosine of the incidence has zeros. For previews of scenes of hundreds of
   * thousands of triangles and more; in smaller scenes EXACT is quicker. A beam within about 1e-6
   * of the scene's size from an edge can be given to the wrong side of the edge. If poses and scene
   * lie on a common grid, so that beams run along edges and through silhouettes, some beams are
   * lost or see what lies behind. The same holds for beams near a needle that points at the sensor,
   * for a few of the beams within 1e-4 radians of a surface, and for one in a thousand of the beams
   * that hit an edge with a surface behind it. In the half space that a sensor on a surface sees
   * through that surface, it gets no return, or ranges as small as rounding. Triangles without area
   * are never hit.
   *
   * The other methods are for comparison. They are tens to thousands of times slower.
   *
   * ANGLE_SUM: section 2.4 of the founding paper, by brute force. The intersection with the plane
   * of a triangle lies inside if the angles between its corners sum to 2 pi, within 1e-6, or if it
   * is closer to a corner than 1e-9 of the range. So a beam that passes an edge of a triangle by
   * less than about 1e-7 of the triangle's size hits it, and a needle narrower than that is a line
   * that hides what lies behind. Documentation/references.md lists the errors of the method as
   * printed in the paper, which are corrected here.
   *
   * MOLLER_TRUMBORE: the textbook test (Moeller and Trumbore 1997) in double precision, by brute
   * force. Triangles that share an edge do not round alike, so beams exactly at edges and vertices
   * can pass between them: of the beams aimed at edges and vertices of an icosphere, one in ten or
   * fifteen.
   *
   * STATIC_CELL_LOCATOR: vtkStaticCellLocator with a tolerance of 1e-9 m. A beam that passes a
   * triangle within the tolerance hits it. A scene must be much larger than the tolerance; where
   * coordinates reach 1e7 m, whose rounding is as large, some beams are lost at edges. Of triangles
   * within the tolerance of one another any one can be returned, and a sensor within the tolerance
   * of a surface can miss what lies behind.
   *
   * With ANGLE_SUM, MOLLER_TRUMBORE and STATIC_CELL_LOCATOR, as with EXACT, triangles without area
   * and triangles whose plane contains the sensor are never hit and hide nothing. Ranges are right
   * to about 13 digits (ANGLE_SUM: 9, if the scene is far away), fewer at a grazing angle.
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
   * How a beam finds the surface, one of IntersectionMethods. Another value is an error
   * (vtkErrorMacro) and changes nothing. The default is EXACT. A change builds the acceleration
   * structure again.
   */
  virtual void SetIntersectionMethod(int method);
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
   * The number of methods, and the name of a method as in the setters above ("AngleSum"), for user
   * interfaces that list all methods. Returns null if `method` is not from 0 to the number - 1.
   */
  static int GetNumberOfIntersectionMethods();
  static const char* GetIntersectionMethodName(int method);
  ///@}

  ///@{
  /**
   * The number of threads, from 0 to 1024. Other values are clamped. 0, the default, stands for all
   * cores.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Whether the scan says what each return has hit. On adds the point arrays that the class
   * documentation lists under "Surface attributes". The default is off. A change does not build the
   * acceleration structure.
   */
  vtkSetMacro(SurfaceAttributes, bool);
  vtkGetMacro(SurfaceAttributes, bool);
  vtkBooleanMacro(SurfaceAttributes, bool);
  ///@}

  /**
   * How the fan is mounted, and which axis the platform turns (Wulf and Wagner, "Fast 3D scanning
   * methods for laser measurement systems", 2003). x points forward, y to the left, z up. Beta
   * turns the fan clockwise, seen from the tip of the axis.
   *
   * YAWING: the fan is vertical, the axis is z through both ends of the fan. While beta is 0, alpha
   * is the elevation above x. A full circle of beta measures each direction once.
   *
   * YAWING_TOP: the fan is vertical, the axis is z through its middle: alpha 0 points up, and,
   * while beta is 0, alpha 90 points along x. Beta from 0 to 180 measures the upper half space
   * once.
   *
   * PITCHING: the fan is level while beta is 0, the axis is y through both ends: alpha 0 points
   * along x, and alpha 90 along y. A positive beta lifts the fan. Beta from -90 to 90 measures the
   * half space in front of the sensor once.
   *
   * ROLLING: the fan is level while beta is 0, the axis is x through its middle: alpha 0 points
   * along x, and alpha 90 along y. A positive beta lowers the left end. Beta from 0 to 180 measures
   * the half space in front of the sensor once.
   */
  enum Mountings
  {
    YAWING = 0,
    YAWING_TOP = 1,
    PITCHING = 2,
    ROLLING = 3
  };

  ///@{
  /**
   * The mounting, one of Mountings. Another value is an error (vtkErrorMacro) and changes nothing.
   * The default is YAWING, the mounting of the founding paper.
   */
  virtual void SetMounting(int mounting);
  vtkGetMacro(Mounting, int);
  void SetMountingToYawing() { this->SetMounting(YAWING); }
  void SetMountingToYawingTop() { this->SetMounting(YAWING_TOP); }
  void SetMountingToPitching() { this->SetMounting(PITCHING); }
  void SetMountingToRolling() { this->SetMounting(ROLLING); }
  const char* GetMountingAsString() const;
  ///@}

  /**
   * The name of a mounting as in the setters above ("YawingTop"). Returns null if `mounting` is not
   * one.
   */
  static const char* GetMountingName(int mounting);

  ///@{
  /**
   * The centre of the mirror, where beams start, relative to the sensor's position: metres along
   * the sensor's x, y and z axes while beta is 0. It turns with the platform. Finite, each
   * coordinate from -1e18 to 1e18. The default is (0, 0, 0): the mirror is on the axis.
   */
  vtkSetVector3Macro(AxisOffset, double);
  vtkGetVector3Macro(AxisOffset, double);
  ///@}

  ///@{
  /**
   * How fast the platform turns while the mirror sweeps a fan, degrees a second. A beam that leaves
   * at the time t after the first of its fan has the platform angle of its turn plus TurnRate t.
   * Any finite number. The default is 0: the platform stands still during each fan. (37.5 turns by
   * 1 degree in a fan in steps of half a degree.)
   */
  vtkSetMacro(TurnRate, double);
  vtkGetMacro(TurnRate, double);
  ///@}

  ///@{
  /**
   * Whether the sensor moves along its trajectory during the scan. On: each beam leaves from the
   * pose at its own time, which is the time of the scan plus that of the beam (ComputeTime).
   * Positions are interpolated linearly, orientations by slerp; after the last time of the
   * trajectory the sensor rests. If it rests during the whole scan, the scan is the same to the bit
   * as without this property. Points and SensorToWorld stay as for a sensor that rests at the pose
   * at the scan's time, which is what a device without odometry reports: the scan is skewed. The
   * field data `TurnToWorld` has the pose at the start of each turn, and ComputePoses adds that of
   * each beam. Without a trajectory it does nothing. The default is off.
   */
  vtkSetMacro(MotionDuringScan, bool);
  vtkGetMacro(MotionDuringScan, bool);
  vtkBooleanMacro(MotionDuringScan, bool);
  ///@}

  /**
   * The devices that SetDevice can choose. Documentation/guide.md lists their values, with sources.
   *
   * IDEAL: the defaults of all properties.
   * LMS200: a SICK LMS 200 that measures in millimetres, up to 8 m.
   * LMS200_CENTIMETRES: the same device in centimetres, up to 80 m.
   * LMS291: a SICK LMS 291, for outdoor use, in centimetres, up to 80 m. Its beam is wider.
   */
  enum Devices
  {
    IDEAL = 0,
    LMS200 = 1,
    LMS200_CENTIMETRES = 2,
    LMS291 = 3
  };

  ///@{
  /**
   * SetDevice sets MaximumRange, BeamDiameter, BeamDivergence, BeamSamples, PulseLength and
   * RangeAtTenPercent to the values of one of Devices. Each can be changed afterwards. Another
   * number is an error (vtkErrorMacro) and changes nothing. Pose, angles and platform belong to the
   * rig and stay. (vtkLMS3DRangeErrorFilter has the errors of ranges of the same devices.)
   * GetDevice returns the first device that has the present values of these properties, -1 if there
   * is none. The default is IDEAL.
   */
  virtual void SetDevice(int device);
  int GetDevice() const;
  void SetDeviceToIdeal() { this->SetDevice(IDEAL); }
  void SetDeviceToLMS200() { this->SetDevice(LMS200); }
  void SetDeviceToLMS200Centimetres() { this->SetDevice(LMS200_CENTIMETRES); }
  void SetDeviceToLMS291() { this->SetDevice(LMS291); }
  ///@}

  ///@{
  /**
   * For user interfaces that list all devices: their number; the name of a device ("Ideal",
   * "LMS200-mm", "LMS200-cm", "LMS291"), null if there is none; and the value that a device gives
   * to a property of vtkLMS3DScanFilter or vtkLMS3DRangeErrorFilter, NaN if there is no such device
   * or if devices do not set this property.
   */
  static int GetNumberOfDevices();
  static const char* GetDeviceName(int device);
  static double GetDeviceValue(int device, const char* property);
  ///@}

  ///@{
  /**
   * The diameter of the beam where it leaves the mirror, metres: its rays start within a disc of
   * this diameter across the beam. Finite, at least 0. It has an effect only if BeamSamples exceeds
   * 1. The default is 0. (LMS 200: 0.012, technical description page 114.)
   */
  vtkSetMacro(BeamDiameter, double);
  vtkGetMacro(BeamDiameter, double);
  ///@}

  ///@{
  /**
   * By how much the diameter of the beam grows, metres for each metre of range, so about radians.
   * The beam is a cone: at the range r its disc has the diameter BeamDiameter + BeamDivergence r.
   * From 0 to 1. It has an effect only if BeamSamples exceeds 1. The default is 0. (LMS 200:
   * 0.0044.)
   */
  vtkSetMacro(BeamDivergence, double);
  vtkGetMacro(BeamDivergence, double);
  ///@}

  ///@{
  /**
   * The number of rays that stand for a beam: one along its axis, the others in rings of 6, 12, 18
   * and so on within its cone, each for the same part of the area. From 1 to 1000. 7, 19, 37 and so
   * on complete a ring; the share of n rays on one side of a straight edge is then that of the area
   * within 0.55 / sqrt(n). The range of a ray is measured along the beam's axis, to about 13
   * digits, so a plane at right angles has the range of the axis. The default is 1: a beam without
   * width. A scan takes about as long as one scan for each ray.
   */
  vtkSetMacro(BeamSamples, int);
  vtkGetMacro(BeamSamples, int);
  ///@}

  ///@{
  /**
   * The length of the pulse, metres. Rays of a beam whose ranges exceed that of the nearest by at
   * most this give one echo, whose range is their mean (a mixed pixel). Rays beyond form further
   * echoes in the same way. Rays that meet nothing up to MaximumRange are no part of an echo. The
   * beam has the range of the echo with the most rays; of equal ones, of the nearest. MinimumRange
   * holds for this range. CellId and the surface attributes come from the echo's ray with the
   * smallest number, which is nearest to the axis. Finite, at least 0. The default is 1 (LMS 200:
   * about 1, technical description page 111).
   */
  vtkSetMacro(PulseLength, double);
  vtkGetMacro(PulseLength, double);
  ///@}

  ///@{
  /**
   * The range r up to which the device sees a surface that reflects 10 percent at right angles,
   * metres. A beam gives no return if reflectance times the cosine of the incidence is below
   * max(0.018, 0.1 (range / r)^2). The incidence is the angle to the normal of the triangle that
   * was hit; both sides of it count. The range is the one before range errors. Finite, at least 0;
   * 0, the default, sees every surface. (LMS 200: 10, technical description pages 7 and 33.)
   */
  vtkSetMacro(RangeAtTenPercent, double);
  vtkGetMacro(RangeAtTenPercent, double);
  ///@}

  ///@{
  /**
   * The name of the scene's cell array with the reflectance of each cell: one component of any
   * number type, 0.1 for 10 percent; retroreflectors exceed 1. An array of three or four components
   * of unsigned char, such as `Color` of a VRML scene, stands for its luminance, from 0 to 1:
   * (0.2126 red + 0.7152 green + 0.0722 blue) / 255 (ITU-R BT.709). The colour is taken as the
   * linear share of the light that the surface reflects, as the diffuse colour of VRML is; opacity
   * does not count. The data sets of a composite may have arrays of different types. It is an error
   * if a cell with a surface does not have the array, or has a reflectance that is negative or not
   * finite. The default is none (null, or an empty name): every surface has the reflectance 1. It
   * has an effect only with RangeAtTenPercent or ComputeIntensity. A change does not build the
   * acceleration structure.
   */
  vtkSetStringMacro(ReflectanceArray);
  vtkGetStringMacro(ReflectanceArray);
  ///@}

  ///@{
  /**
   * Whether the scan has the point array `Incidence` (float32, degrees): the angle between the beam
   * and the normal of the triangle that was hit, 0 to 90. The default is off. (SurfaceAttributes
   * adds the same array. If both are on, there is one.)
   */
  vtkSetMacro(ComputeIncidence, bool);
  vtkGetMacro(ComputeIncidence, bool);
  vtkBooleanMacro(ComputeIncidence, bool);
  ///@}

  ///@{
  /**
   * Whether the scan has the point array `Intensity` (float32), behind `Incidence`: reflectance
   * (see ReflectanceArray) times the cosine of the incidence. It does not fall with the range. The
   * default is off.
   */
  vtkSetMacro(ComputeIntensity, bool);
  vtkGetMacro(ComputeIntensity, bool);
  vtkBooleanMacro(ComputeIntensity, bool);
  ///@}

  ///@{
  /**
   * Whether the scan has the point array `Time` (float64, seconds): when the beam left. It starts
   * at the time of the scan's pose, or at 0 without a trajectory. The mirror turns 75 times a
   * second; a fan in steps of 1/n degree takes n turns of it, and its beams are interlaced (whole
   * degrees first; SICK's telegram listing, pages 19 and 127). The default is off.
   */
  vtkSetMacro(ComputeTime, bool);
  vtkGetMacro(ComputeTime, bool);
  vtkBooleanMacro(ComputeTime, bool);
  ///@}

  /**
   * Why a beam gave a return, or none. NOTHING_MET: there is no surface along the beam at any
   * range. BEYOND_RANGE: the nearest surface is beyond MaximumRange. TOO_WEAK: RangeAtTenPercent
   * removed the return. TOO_NEAR: the nearest surface is nearer than MinimumRange.
   * (vtkLMS3DRangeErrorFilter adds the returns whose ranges it cannot report.) For a beam with a
   * width, the echo that it would report without limits decides between these.
   */
  enum BeamStatus
  {
    RETURN = 0,
    NOTHING_MET = 1,
    BEYOND_RANGE = 2,
    TOO_WEAK = 3,
    TOO_NEAR = 4
  };

  ///@{
  /**
   * Whether the outputs have the array `Status` (unsigned char, one of BeamStatus, for each beam of
   * the grid, turn by turn): point data of the range image, and field data of the scan, in shared
   * memory. The default is off. Returns are the same to the bit, on or off. If some beams have no
   * return and the ranges have limits, the filter casts all beams a second time, without limits.
   */
  vtkSetMacro(ComputeStatus, bool);
  vtkGetMacro(ComputeStatus, bool);
  vtkBooleanMacro(ComputeStatus, bool);
  ///@}

  ///@{
  /**
   * Whether the scan has, for each return, the pose of the sensor when the beam left: the point
   * arrays `SensorPosition` (float64, 3 components, metres) and `SensorOrientation` (float64, 4
   * components, a quaternion w x y z). The default is off.
   */
  vtkSetMacro(ComputePoses, bool);
  vtkGetMacro(ComputePoses, bool);
  vtkBooleanMacro(ComputePoses, bool);
  ///@}

  ///@{
  /**
   * The trajectory, input 1: a vtkPolyData whose points are the poses of the sensor, as the class
   * documentation describes. The default is none.
   */
  void SetTrajectoryConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetTrajectoryData(vtkDataObject* poses) { this->SetInputDataObject(1, poses); }
  ///@}

  ///@{
  /**
   * The processes that scan together. Null, or a controller of one process, stands for this process
   * alone. The default is the global controller at the time of construction. All processes must
   * update the filter, with the same properties.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * The time when the acceleration structure was last built, 0 before the first build. It shows
   * whether an update had to build.
   */
  vtkMTimeType GetBuildTime() const;

  /**
   * Output 1, the range image.
   */
  vtkImageData* GetRangeImage();

  /**
   * Casts the fan at one platform angle `beta` (degrees, finite), without the pipeline: for a
   * device in real time, where an update of a single fan would take most of its time in the
   * pipeline. Fills `ranges` (metres, NaN without a return) with one value for each beam, and
   * `status`, if it is not null, with one of BeamStatus. The values equal the range image of an
   * update for `time` (seconds; for a trajectory) with BetaRange (beta, beta) and BetaResolution 1.
   *
   * Uses the inputs as they are: their own filters are not updated. If the scene has changed, its
   * acceleration structure is built first. The outputs and the error code do not change. It cannot
   * be aborted. Do not call it during an update.
   *
   * Returns false after an error (vtkErrorMacro): for example without `ranges`, without a scene, or
   * with a controller of several processes. The values in the arrays are then undefined.
   */
  bool CastFan(double beta, double time, vtkDoubleArray* ranges, vtkUnsignedCharArray* status);

protected:
  vtkLMS3DScanFilter();
  ~vtkLMS3DScanFilter() override;

  /// Returns an executive without the loops over composite inputs: the filter takes a composite
  /// scene whole, and refuses a composite trajectory.
  vtkExecutive* CreateDefaultExecutive() override;

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
  bool SurfaceAttributes = false;
  int Mounting = YAWING;
  double AxisOffset[3] = { 0.0, 0.0, 0.0 };
  double TurnRate = 0.0;
  bool MotionDuringScan = false;
  double BeamDiameter = 0.0;
  double BeamDivergence = 0.0;
  int BeamSamples = 1;
  double PulseLength = 1.0;
  double RangeAtTenPercent = 0.0;
  char* ReflectanceArray = nullptr;
  bool ComputeIncidence = false;
  bool ComputeIntensity = false;
  bool ComputeTime = false;
  bool ComputeStatus = false;
  bool ComputePoses = false;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
