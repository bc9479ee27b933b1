// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Waits for a scan also where the server has no room for one more who waits.
 */
#ifndef lms3dWaitForScan_h
#define lms3dWaitForScan_h

#include "LMS3DScanner.hh"

#include <chrono>

/// As waitForScan(). Where too many others wait already, the client pauses by itself and then looks.
LMS3D::ScanHeader* lms3dWaitForScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after,
  CORBA::ULongLong generation, CORBA::ULong milliseconds, std::chrono::milliseconds pause);

#endif
