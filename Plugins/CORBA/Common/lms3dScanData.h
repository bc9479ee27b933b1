// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan with its local map, as it travels between server and client.
 */
#ifndef lms3dScanData_h
#define lms3dScanData_h

#include "Common/lms3dDeviceNames.h"
#include "LMS3DScanner.hh"

#include <cstdint>
#include <vector>

struct lms3dScanData
{
  LMS3D::ScanHeader Header;
  LMS3D::Device Device = lms3dGetIdealDevice();
  /// Metres, 0 without a return. The index is turn * alpha.count + beam.
  std::vector<float> Ranges;
  /// One of the BEAM_ constants for each beam. Empty unless Device.computeStatus.
  std::vector<std::uint8_t> Statuses;
  /// x, y, z of each point of the local map, metres, world coordinates.
  std::vector<double> MapPoints;
  /// Three indices of points per triangle.
  std::vector<std::uint32_t> MapTriangles;
};

#endif
