// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One update of vtkLMS3DScanFilter, from its inputs to its outputs.
 */
#ifndef lms3dScanJob_h
#define lms3dScanJob_h

#include "Pipeline/lms3dProgress.h"
#include "Pipeline/lms3dThreads.h"
#include "Scan/lms3dBuiltScene.h"
#include "Scan/lms3dDetection.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dScanOutput.h"
#include "Scan/lms3dScanSensor.h"
#include "Scan/lms3dScanSettings.h"
#include "Scan/lms3dScanStart.h"

#include <vtkType.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

class vtkDataObject;
class vtkDoubleArray;
class vtkFieldData;
class vtkImageData;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;
class vtkUnsignedCharArray;

/// What one update needs. Everything that a pointer or reference refers to must outlive the update.
struct lms3dScanJobRequest
{
  const lms3dScanSettings& Settings;

  /// The processes that scan together; null stands for this process alone.
  vtkMultiProcessController* Controller;

  vtkDataObject* Scene;

  /// Null if the sensor stands at the settings' pose.
  vtkPolyData* Trajectory;

  /// The requested time, seconds.
  std::optional<double> Time;

  /// Output 0, a vtkPolyData, and output 1, a vtkImageData. Both must be empty.
  vtkInformationVector* Outputs;

  /// Called on the calling thread.
  lms3dProgress Progress;
  std::function<void(const std::string&)> Warn;
};

/// Keeps from update to update what need not be computed again: the acceleration structure, the
/// tables of angles, the trajectory, threads and memory.
class lms3dScanJob
{
public:
  /**
   * Fills the outputs. The settings must be good. Throws std::runtime_error, with a text for the
   * user, if the scene or the trajectory is bad or memory is short; in all processes if it fails in
   * one. Returns false, in all processes, with empty outputs that the next update fills, if
   * `Progress` stopped the work in one of them.
   */
  bool Run(const lms3dScanJobRequest& request);

  /**
   * Fills `ranges`, and `status` if the settings want it, with the values of the range image that
   * Run gives. The request's controller must be null, and its outputs are not used. Throws and
   * returns as Run does.
   */
  bool CastRanges(
    const lms3dScanJobRequest& request, vtkDoubleArray* ranges, vtkUnsignedCharArray* status);

  /// Wakes the threads for a run with these settings that follows soon, unless they are awake for
  /// it. If `canPlan`, one of them plans the scan of the present scene from the settings' pose. The
  /// run uses the plan if it fits.
  void Wake(const lms3dScanSettings& settings, bool canPlan);

  /// Returns whether there is a plan for the next run. Waits for a thread that makes one.
  bool HasPlan();

  /// Returns the poses, read again only if the trajectory or the orientation (degrees, for points
  /// without one) changed. Throws std::runtime_error, with a text for the user, if they are bad.
  const lms3dTrajectory& GetTrajectory(vtkPolyData* poses, const lms3dVector& orientation)
  {
    return this->Sensor.GetTrajectory(poses, orientation);
  }

  /// Returns the time when the acceleration structure was last built, 0 before the first.
  vtkMTimeType GetBuildTime() const { return this->Scene.GetBuildTime(); }

private:
  /// One run: the request, and what all its steps use.
  struct Scan
  {
    const lms3dScanJobRequest& Request;
    const lms3dProcesses& Processes;
    const lms3dScanGeometry& Geometry;
    const lms3dScanStart& Start;

    /// Null if nothing needs them.
    const lms3dMovingBeams* const Beams;

    const lms3dProgress Progress;

    ///@{
    /// Null if only the ranges are needed.
    vtkPolyData* const Points;
    vtkImageData* const Image;
    ///@}
  };

  void EndWait();
  bool CanPlan(const lms3dScanSettings& settings) const;
  void MakePlan(const lms3dScanSettings& settings);
  bool Prepare(
    const lms3dScanJobRequest& request, const lms3dProcesses& processes, lms3dScanStart& start);
  bool Build(const lms3dScanJobRequest& request, bool isUpToDate, bool isParallel);
  bool CastWhole(const Scan& scan);
  bool CastAlone(const Scan& scan);
  bool CastInParallel(const Scan& scan);
  bool CastAndDetect(const Scan& scan, std::int64_t firstCell);
  void FillOutputsInParallel(const Scan& scan);
  static void AddPoses(const Scan& scan);
  void AddSurfaceAttributes(const Scan& scan, vtkFieldData* data) const;
  void WarnIfIncomplete(const lms3dScenePart& scene, const Scan& scan);

  lms3dBuiltScene Scene;
  lms3dScanSensor Sensor;

  /// After the scene and the sensor, since its plan refers to both.
  lms3dScanOutput Output;
  lms3dDetection Detection;

  /// The last warnings, which are not repeated for each pose.
  std::string SkippedCells;
  std::string MissingCells;

  /// The settings of the last Wake.
  std::optional<lms3dScanSettings> WokenSettings;

  /// The last member, since the threads can use the others until it is destroyed.
  lms3dThreads Threads;
};

#endif
