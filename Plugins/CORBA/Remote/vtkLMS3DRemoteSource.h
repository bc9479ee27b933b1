// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DRemoteSource
 * @brief   shows the scans of a running LMS3D server
 *
 * vtkLMS3DRemoteSource follows an lms3d-server, or any other server of the CORBA interface
 * LMS3D::LaserScanner (Plugins/CORBA/LMS3DScanner.idl), and outputs its newest scan. A thread of its
 * own fetches the scans; updates only take what it has fetched and never wait for the network, but
 * for the first one. So the source suits a window that is drawn again while scans come:
 *
 *     if (source->GetNeedsUpdate()) { window->Render(); }
 *
 * asked some times a second is all it takes; in ParaView its live sources do so.
 *
 * Output 0, the scan, is the vtkPolyData that vtkLMS3DScanFilter has as its first output: points in
 * world coordinates (float64) with the arrays `Range` (float64, metres), `Alpha`, `Beta` (float32,
 * degrees) and `BeamId` (int32) and the field data `AlphaAngles`, `BetaAngles` and `SensorToWorld`. So
 * vtkLMS3DSurfaceReconstructionFilter takes it. Servers send ranges in single precision, with an error
 * of up to 6e-8 of the range; points are computed from them in double, as that filter does. There is
 * no `CellId`.
 *
 * Output 1, the local map, is a vtkPolyData of triangles in world coordinates, counter-clockwise seen
 * from the sensor; without any where the server makes no maps.
 *
 * Both have as field data (one uint64 each) `ScanNumber`, `Incarnation` (of the server's start),
 * `Generation` (of the settings), `StartTime` and `EndTime` (nanoseconds since 1970, the server's
 * clock), and the name of the `Scene`.
 *
 * A server may stop, hang, and be started anew: the last scan stays, with a warning, and the source
 * goes on by itself within a second after the server does, with `file:` as its URL also at another
 * address. What a server sends is checked before it is used, its checksums included: a scan that is
 * not as the interface demands is not shown.
 *
 * omniORB's configuration file and environment variables hold for it too, so that it speaks TLS where
 * these name certificates (Documentation/corba.md).
 *
 * There is one sensor for all clients. SendPose() moves it, unless the server was started so that
 * clients may not.
 *
 * The output is empty, with a warning, as long as no server answers; without a URL with an error and
 * the error code vtkErrorCode::UserError. Of several processes only the first talks to the server.
 *
 * Destruction never waits: a thread that waits for an answer just then ends by itself, at the latest
 * after Timeout, or two where it waits for a naming service, for which only the end of the process waits.
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

struct lms3dRemoteNews;

class VTKLMS3DREMOTE_EXPORT vtkLMS3DRemoteSource : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DRemoteSource* New();
  vtkTypeMacro(vtkLMS3DRemoteSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the server is, empty by default; what the server prints when it starts:
   * - `corbaloc:iiop:1.2@HOST:PORT/LMS3D`, which stays the same when the server is started anew at the
   *   same port;
   * - `IOR:` and its digits;
   * - `corbaname:iiop:1.2@HOST:PORT#LMS3D.Scanner`, to ask the naming service at that address;
   * - `file:PATH`, a file with one of these (the server's option --ior), read by each attempt anew.
   */
  vtkSetStdStringFromCharMacro(URL);
  vtkGetCharFromStdStringMacro(URL);
  ///@}

  ///@{
  /**
   * How long the server may take for an answer, be it a whole scan in many parts, and a naming service
   * for its own, and how long the first update waits for a scan at most, seconds. 0.5 to 60; the
   * default is 2.
   */
  vtkSetClampMacro(Timeout, double, 0.5, 60.0);
  vtkGetMacro(Timeout, double);
  ///@}

  ///@{
  /**
   * The pose that SendPose() sends: the sensor's position in the server's scene, metres, and its
   * orientation, degrees, as those of vtkLMS3DScanFilter. Finite numbers, positions up to 1e6; the
   * default is 0 for all. They do not follow the server: SensorToWorld tells the pose of a scan.
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  vtkSetVector3Macro(Orientation, double);
  vtkGetVector3Macro(Orientation, double);
  ///@}

  /**
   * Sends Position and Orientation to the server, which takes them up with its next scan. Returns at
   * once; the pose is sent within 0.2 seconds, or as soon as the server answers, and again where the
   * server is gone before a scan came from there. Only the newest pose counts. An update warns of one
   * that the server refuses.
   */
  void SendPose();

  /**
   * True from SendPose() on, until an update has the first scan from there or warns that the server
   * refuses.
   */
  bool IsPosePending() const;

  /**
   * True, and the source is modified, where there is something newer than the last update showed.
   * Waits for nothing. False before the first update or SendPose(), and after an update without a URL.
   */
  bool GetNeedsUpdate();

  /**
   * Why no newer scans come, or why the last pose was not taken, in words for the user; empty where
   * all is well. Asks nobody.
   */
  std::string GetProblem() const;

  /**
   * The second output.
   */
  vtkPolyData* GetLocalMap();

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
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Orientation[3] = { 0.0, 0.0, 0.0 };

  void Warn(const lms3dRemoteNews& news);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
