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
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

using lms3dRemoteScanPointer = std::shared_ptr<const lms3dRemoteScan>;

/// The server's answer: no.
class lms3dRemoteRefusal : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * One run of a server. Every method talks to it, and throws lms3dRemoteRefusal where the server refuses
 * and std::runtime_error where it is gone or takes too long, after which this is not to be used again.
 */
class lms3dRemoteServer
{
public:
  /// `timeout` is what a call may take, and the whole of a scan, between whose parts `isStopped` is asked
  /// whether anybody still wants it.
  lms3dRemoteServer(
    const std::string& url, std::chrono::milliseconds timeout, std::function<bool()> isStopped);

  /// The newest scan that this has not returned before, whole and checked; null where there is none
  /// within `milliseconds`, or where it was gone before all of it was fetched.
  lms3dRemoteScanPointer WaitForScan(std::uint32_t milliseconds);

  /// Why the server has no scans, in its own words; empty where it has.
  std::string GetProblem();

  /// The generation of the scans from there.
  std::uint64_t SetPose(const LMS3D::Pose& pose);

private:
  template <typename Result, typename Call>
  Result Ask(const Call& call) const;
  LMS3D::ScanHeader_var WaitForHeader(std::uint32_t milliseconds);
  lms3dRemoteScanPointer Fetch(const LMS3D::ScanHeader& header) const;
  void LimitCalls(std::chrono::milliseconds timeout) const;
  void CheckRun(std::uint64_t incarnation);

  const std::chrono::milliseconds Timeout;
  const std::function<bool()> IsStopped;
  LMS3D::LaserScanner_var Scanner;
  /// 0 before the server has told it.
  std::uint64_t Incarnation = 0;
  std::uint64_t Seen = 0;
  int GoneInARow = 0;
};

#endif
