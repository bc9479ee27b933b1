// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A connection to a server, for one thread.
 */
#ifndef lms3dRemoteServer_h
#define lms3dRemoteServer_h

#include "Client/lms3dRemoteFusedMap.h"
#include "Client/lms3dRemoteScan.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

using lms3dRemoteScanPointer = std::shared_ptr<const lms3dRemoteScan>;
using lms3dRemoteFusedMapPointer = std::shared_ptr<const lms3dRemoteFusedMap>;

/// The server is there, but refuses the request.
class lms3dRemoteRefusal : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * One run of a server. Every method sends requests. It throws lms3dRemoteRefusal if the server
 * refuses one, and std::runtime_error if the server is gone, has restarted or takes too long; do
 * not use the object afterwards, unless FetchFusedMap() threw. For one thread.
 */
class lms3dRemoteServer
{
public:
  /// `timeout` limits each call, and all parts of a scan together. `isStopped` is called before
  /// each part and ends the fetch by returning true.
  lms3dRemoteServer(
    const std::string& url, std::chrono::milliseconds timeout, std::function<bool()> isStopped);

  /// Returns the newest scan that was not returned before, complete and checked. Returns null if
  /// there is none within `milliseconds`, or if the server dropped it before all parts were
  /// fetched.
  lms3dRemoteScanPointer WaitForScan(std::uint32_t milliseconds);

  /// Fetches what has changed in the map of many scans. Returns the newest map, which is the same
  /// object as before if nothing has changed, or if the server dropped a state before all parts
  /// were fetched; null before the first. Throws lms3dRemoteRefusal if the server has no such map.
  lms3dRemoteFusedMapPointer FetchFusedMap();

  /// Why the newest scans are not in the map of the last FetchFusedMap(). Empty if they are.
  std::string GetFusedMapProblem() const { return this->FusedMap.GetHeader().problem.in(); }

  /// The server's reason for having no scans. Empty if it has scans.
  std::string GetProblem();

  /// Moves the sensor and returns the generation of its scans.
  std::uint64_t SetPose(const LMS3D::Pose& pose);

private:
  template <typename Result, typename Call>
  Result Invoke(const Call& call) const;
  LMS3D::ScanHeader_var WaitForHeader(std::uint32_t milliseconds);
  lms3dRemoteScanPointer Fetch(const LMS3D::ScanHeader& header) const;
  /// Calls `fetch` with a function for it to call before each message, which throws CORBA::TIMEOUT
  /// after the timeout and if the object is stopped. Throws std::runtime_error with `problem` then.
  void FetchInTime(
    const std::function<void(const std::function<void()>&)>& fetch, const char* problem) const;
  void LimitCalls(std::chrono::milliseconds timeout) const;
  void CheckRun(std::uint64_t incarnation);

  const std::chrono::milliseconds Timeout;
  const std::function<bool()> IsStopped;
  LMS3D::LaserScanner_var Scanner;
  /// 0 before the first answer.
  std::uint64_t Incarnation = 0;
  /// The number of the last scan.
  std::uint64_t LastNumber = 0;
  int DroppedInARow = 0;
  lms3dRemoteFusedMap FusedMap;
  /// A copy that users share.
  lms3dRemoteFusedMapPointer NewestFusedMap;
};

#endif
