// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DRemoteSource
 * @brief   shows the scans of a running LMS3D server
 *
 * vtkLMS3DRemoteSource follows an lms3d-server, or any other server of the CORBA interface
 * LMS3D::LaserScanner (Plugins/CORBA/IDL/LMS3DScanner.idl), and outputs its newest scan. A thread
 * of its own fetches the scans. Updates only take what the thread has fetched and never wait for
 * the network, except for the first scan. A window that shows the source calls this some times per
 * second:
 *
 *     if (source->GetNeedsUpdate()) { window->Render(); }
 *
 * In ParaView, live sources do the same. A script, which draws nothing, waits for a new scan:
 *
 *     while (source->Refresh()) { source->Update(); ... }
 *
 * Output 0, the scan, is a vtkPolyData like the first output of vtkLMS3DScanFilter: points in world
 * coordinates (float64) with the arrays `Range` (float64, metres), `Alpha`, `Beta` (float32,
 * degrees) and `BeamId` (int32) and the field data `AlphaAngles`, `BetaAngles` and `SensorToWorld`.
 * So vtkLMS3DSurfaceReconstructionFilter accepts it. `Mounting`, `AxisOffset` and `TurnRate` are
 * added if they differ from the defaults of vtkLMS3DScanFilter, and `Status` if the server's device
 * has statuses. (Servers without a device are ideal.) Servers send ranges in single precision, with
 * an error of up to 6e-8 of the range; points are computed from them in double precision. There is
 * no `CellId`.
 *
 * Output 1, the local map, is a vtkPolyData of triangles in world coordinates, counter-clockwise
 * seen from the sensor. It is empty if the server makes no maps.
 *
 * Output 2, the fused map, is the server's map of many scans: triangles with the cell array
 * `RegionId` (int32) and the field data `NumberOfScans` (int32) and `State` (uint64), the number of
 * its state. It is empty unless FetchFusedMap is on and the server has the option --fused-map.
 * Points have single precision, relative to the map's first pose. Only what changes is fetched.
 *
 * The field data of outputs 0 and 1 have (one uint64 each) `ScanNumber`, `Incarnation` (of the
 * server's start), `Generation` (of the settings), `StartTime` and `EndTime` (nanoseconds since
 * 1970, the server's clock), and the name of the `Scene`.
 *
 * If a server stops, hangs or restarts, the last scan stays, with a warning, and the source goes on
 * within a second after the server does. With a `file:` URL it also finds a server that restarts at
 * another address. What a server sends is checked before it is used, including the checksums. A
 * scan that violates the interface is not shown.
 *
 * omniORB's configuration file and environment variables apply here too. If they name certificates,
 * the source uses TLS (Documentation/corba-security.md).
 *
 * All clients share one sensor. SendPose() moves it, unless the server forbids that.
 *
 * As long as no server answers, the output is empty, with a warning. Without a URL, an update fails
 * with an error and the error code vtkErrorCode::UserError. In parallel, only the first process
 * connects to the server.
 *
 * The destructor never waits. A thread that is waiting for an answer ends on its own after Timeout
 * at the latest, or twice that if it waits for a naming service. Only the end of the process waits
 * for it.
 *
 * @sa
 * vtkLMS3DScanFilter vtkLMS3DSurfaceReconstructionFilter
 */
#ifndef vtkLMS3DRemoteSource_h
#define vtkLMS3DRemoteSource_h

#include "vtkLMS3DRemoteModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKLMS3DREMOTE_EXPORT vtkLMS3DRemoteSource : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DRemoteSource* New();
  vtkTypeMacro(vtkLMS3DRemoteSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The address of the server, as the server prints it when it starts. Empty by default. One of:
   * - `corbaloc:iiop:1.2@HOST:PORT/LMS3D`, which stays valid if the server restarts at the same
   *   port;
   * - `IOR:` followed by digits;
   * - `corbaname:iiop:1.2@HOST:PORT#LMS3D.Scanner`, a name in the naming service at that address;
   * - `file:PATH`, a file with one of these (the server's option --ior), read again by each
   *   attempt.
   */
  vtkSetStdStringFromCharMacro(URL);
  vtkGetCharFromStdStringMacro(URL);
  ///@}

  ///@{
  /**
   * The time limit, in seconds, of an answer of the server, of all parts of a scan together, of an
   * answer of a naming service, and of the first update's wait for a scan. 0.5 to 60; the default
   * is 2.
   */
  vtkSetClampMacro(Timeout, double, 0.5, 60.0);
  vtkGetMacro(Timeout, double);
  ///@}

  ///@{
  /**
   * The pose that SendPose() sends: the sensor's position in the server's scene, metres, and its
   * orientation, degrees, as in vtkLMS3DScanFilter. Each number is from -1e6 to 1e6; the server
   * refuses others. The default is 0 for all. These properties do not follow the server:
   * SensorToWorld is the pose of a scan.
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  vtkSetVector3Macro(Orientation, double);
  vtkGetVector3Macro(Orientation, double);
  ///@}

  /**
   * Sends Position and Orientation to the server, which uses them from its next scan on. Returns at
   * once. The thread sends the pose within 0.2 seconds, or as soon as the server answers. If the
   * server ends before a scan from there arrives, the pose is sent again after its restart. Only
   * the newest pose counts. If the server refuses it, the next update warns.
   */
  void SendPose();

  /**
   * True from SendPose() on, until an update has the first scan from that pose or warns that the
   * server refuses it.
   */
  bool IsPosePending() const;

  /**
   * If there is something newer than the last update showed, marks the source as modified and
   * returns true. Never waits. Returns false before the first update or SendPose(), and after an
   * update without a URL.
   */
  bool GetNeedsUpdate();

  /**
   * Waits, up to Timeout, for a scan that is newer than the last update showed. After SendPose(),
   * waits for the first scan from that pose; if the server refuses the pose, for any newer scan.
   * Marks the source as modified, so that the next update shows the newest scan. Returns false if
   * no such scan came in time. Returns true at once before the first update, because that waits
   * itself.
   */
  bool Refresh();

  /**
   * Why no newer scans come, or why the server refused the last pose, as a message for the user.
   * Empty if there is no problem. Never waits.
   */
  std::string GetProblem() const;

  ///@{
  /**
   * Whether the third output is made. Off by default. A change has effect from the next scan on. If
   * the server has no such map, updates warn once.
   */
  vtkSetMacro(FetchFusedMap, bool);
  vtkGetMacro(FetchFusedMap, bool);
  vtkBooleanMacro(FetchFusedMap, bool);
  ///@}

  /**
   * The second output.
   */
  vtkPolyData* GetLocalMap();

  /**
   * The third output.
   */
  vtkPolyData* GetFusedMap();

protected:
  vtkLMS3DRemoteSource();
  ~vtkLMS3DRemoteSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DRemoteSource(const vtkLMS3DRemoteSource&) = delete;
  void operator=(const vtkLMS3DRemoteSource&) = delete;

  std::string URL;
  double Timeout = 2.0;
  bool FetchFusedMap = false;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Orientation[3] = { 0.0, 0.0, 0.0 };

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
