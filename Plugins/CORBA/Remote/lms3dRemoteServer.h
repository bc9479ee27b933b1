// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A server, as one thread talks to it.
 */
#ifndef lms3dRemoteServer_h
#define lms3dRemoteServer_h

#include "lms3dRemoteScan.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

using lms3dRemoteScanPointer = std::shared_ptr<const lms3dRemoteScan>;

/**
 * Every method talks to the server, and throws std::runtime_error where that fails or takes too long.
 */
class lms3dRemoteServer
{
public:
  lms3dRemoteServer(const std::string& url, std::chrono::milliseconds timeout);

  /// The newest scan that this has not returned before, whole and checked; null where there is none
  /// within `milliseconds`, or where it was gone before all of it was fetched.
  lms3dRemoteScanPointer WaitForScan(std::uint32_t milliseconds);

  /// Why the server has no scans, in its own words; empty where it has.
  std::string GetProblem();

  void SetPose(const LMS3D::Pose& pose);

private:
  template <typename Result, typename Call>
  Result Ask(const Call& call) const;
  LMS3D::ScanHeader_var WaitForHeader(std::uint32_t milliseconds);
  lms3dRemoteScanPointer Fetch(const LMS3D::ScanHeader& header) const;

  LMS3D::LaserScanner_var Scanner;
  std::uint64_t Seen = 0;
  int GoneInARow = 0;
};

#endif
