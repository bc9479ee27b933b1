// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan of a server, fetched as a whole.
 */
#ifndef lms3dRemoteScan_h
#define lms3dRemoteScan_h

#include "LMS3DScanner.hh"

#include <cstdint>
#include <functional>
#include <vector>

struct lms3dRemoteScan
{
  LMS3D::ScanHeader Header;
  /// Metres, 0 without a return; turn * alpha.count + beam.
  std::vector<float> Ranges;
  /// x, y, z of each point of the local map, metres, world coordinates.
  std::vector<double> MapPoints;
  /// Three point numbers of each triangle.
  std::vector<std::uint32_t> MapTriangles;
};

/**
 * Fetches the scan of a header, and its map, in as many messages as it takes. Throws LMS3D::ScanGone
 * where the server has dropped it meanwhile, std::runtime_error where what it sends is not as it has to
 * be (lms3dRemoteCheck.h). `beforePart` is called before each message, and ends the fetch by throwing.
 */
lms3dRemoteScan lms3dFetchScan(
  LMS3D::LaserScanner_ptr scanner, const LMS3D::ScanHeader& header,
  const std::function<void()>& beforePart = [] {});

#endif
