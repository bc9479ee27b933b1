// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sensor of vtkLMS3DScanFilter: its angles, and its pose at the requested time.
 */
#ifndef lms3dScanSensor_h
#define lms3dScanSensor_h

#include "Device/lms3dScanGeometry.h"
#include "Device/lms3dTrajectory.h"
#include "Scan/lms3dScanSettings.h"
#include "Scan/lms3dScanStart.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <memory>
#include <optional>

class vtkPolyData;

/// Keeps the tables of angles and the trajectory from update to update. References to them are
/// valid until the next call with other arguments.
class lms3dScanSensor
{
public:
  const lms3dScanGeometry& GetGeometry(const lms3dScanSettings& settings);

  /// Returns whether GetGeometry returns what it returned last.
  bool HasGeometry(const lms3dScanSettings& settings) const;

  /// Returns the poses, read again only if the trajectory or the orientation (degrees, for points
  /// without one) changed. Throws std::runtime_error, with a text for the user, if they are bad.
  const lms3dTrajectory& GetTrajectory(vtkPolyData* poses, const lms3dVector& orientation);

  /// Returns the pose of the settings if `trajectory` is null; otherwise the trajectory's pose at
  /// `time` (seconds), or the first if there is no time, with the time of that pose, and with the
  /// motion from there, if the settings want it and the sensor does not rest.
  lms3dScanStart GetStart(
    const lms3dScanSettings& settings, vtkPolyData* trajectory, std::optional<double> time);

private:
  /// First and last elevation (degrees) and their number, and the same of the turns.
  using Angles = std::array<double, 6>;
  static Angles GetAngles(const lms3dScanSettings& settings);

  std::unique_ptr<lms3dScanGeometry> Geometry;
  Angles GeometryAngles;

  std::unique_ptr<lms3dTrajectory> Trajectory;
  vtkSmartPointer<vtkPolyData> TrajectoryData;
  vtkMTimeType TrajectoryTime = 0;
  lms3dVector TrajectoryOrientation;
};

#endif
