// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans by devices of all kinds, and what their beams must measure in a box.
 */
#ifndef DeviceFixtures_h
#define DeviceFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <iosfwd>
#include <vector>

/// A box of twelve triangles about the origin, seen from inside.
vtkSmartPointer<vtkPolyData> MakeBoxScene(const Point& halfSizes);

/// The distance from a point within the box to its surface.
double GetRangeInBox(const Point& halfSizes, const Point& from, const Point& direction);

/// The direction of a beam in the sensor's axes, written down from the documentation of
/// vtkLMS3DScanFilter::Mountings. Degrees.
Point GetMountedDirection(int mounting, double alpha, double beta);

/// Turns a vector by a quaternion w x y z of length 1.
Point Rotate(const std::vector<double>& quaternion, const Point& v);

/// Two poses, 0.1 m and 20 degrees apart, so that the sensor moves during a scan of one second.
vtkSmartPointer<vtkPolyData> MakeShortDrive(double duration = 1.0);

/// The values of a point array.
std::vector<double> GetValues(vtkLMS3DScanFilter* scan, const char* name);

/// Sets a device that differs from the default one. Shown by its name.
struct Device
{
  const char* Name;
  void (*Apply)(vtkLMS3DScanFilter*);
};
void PrintTo(const Device& device, std::ostream* os);

/// Devices that leave the default path of a scan in all ways.
const std::vector<Device>& GetDevices();

/// A fingerprint of both outputs.
std::uint64_t HashOutputs(vtkLMS3DScanFilter* scan);

#endif
