// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for scans of a server and fetches them.
 */
#ifndef lms3dRemoteScan_h
#define lms3dRemoteScan_h

#include "Common/lms3dScanData.h"

#include <chrono>
#include <functional>

using lms3dRemoteScan = lms3dScanData;

/**
 * Fetches the scan of a header, its device and its map, in as many messages as necessary, and
 * checks them (lms3dRemoteCheck.h). The device of a server without this operation is ideal. Calls
 * `beforePart` before each message; an exception from it ends the fetch. Throws LMS3D::ScanGone if
 * the server has dropped the scan meanwhile, std::runtime_error if the data are invalid, and
 * CORBA::SystemException.
 */
lms3dRemoteScan lms3dFetchScan(
  LMS3D::LaserScanner_ptr scanner, const LMS3D::ScanHeader& header,
  const std::function<void()>& beforePart = [] {});

/**
 * Calls waitForScan(), with a timeout in milliseconds. If the server has no place for another
 * waiting call, pauses and then checks the newest scan. The caller owns the result. Throws
 * LMS3D::NoScanYet if there is no such scan, and CORBA::SystemException.
 */
LMS3D::ScanHeader* lms3dWaitForScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after,
  CORBA::ULongLong generation, CORBA::ULong timeout, std::chrono::milliseconds pause);

#endif
