// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Follows a server in a thread of its own.
 */
#ifndef lms3dRemoteWatch_h
#define lms3dRemoteWatch_h

#include "Remote/lms3dRemoteServer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

/// The state of a server, as far as a client has received it.
struct lms3dRemoteNews
{
  /// Grows with each change of the other members. 0 before the first change.
  std::uint64_t Count = 0;
  /// The newest scan. Null before the first.
  lms3dRemoteScanPointer Scan;
  /// The number of scans so far, the newest one included.
  std::uint64_t Scans = 0;
  /// The map of many scans. Null if it is not wanted, or the server has none.
  lms3dRemoteFusedMapPointer FusedMap;
  /// Why the map of many scans is missing or does not grow. Empty if it is not wanted.
  std::string FusedMapProblem;
  /// Why no newer scans come. Empty while they come.
  std::string Problem;
  /// Why the server refused the last pose. Empty if it accepted the pose or has not answered yet.
  std::string Refusal;
  /// True until the last pose is refused or the first scan from it arrives.
  bool IsPosePending = false;
};

/**
 * One thread calls Run() and sends the requests. Other threads read the news and never wait for the
 * network. If a request fails, e.g. because the server is restarting, the failure is reported as a
 * problem and tried again. All methods but Run() may be called from any thread.
 */
class lms3dRemoteWatch
{
public:
  /// `timeout` limits each call, and all parts of a scan together.
  lms3dRemoteWatch(std::string url, std::chrono::milliseconds timeout);

  /// Follows the server until Stop(). May return a timeout later.
  void Run();

  /// Returns at once.
  void Stop();

  /// The Count of the news.
  std::uint64_t GetCount() const;
  lms3dRemoteNews GetNews() const;

  /// Waits for the first scan or problem, up to the timeout. Returns at once afterwards.
  lms3dRemoteNews WaitForNews() const;

  /// Waits until there are more than `scans` scans and no pose is pending, up to the timeout.
  /// Returns false if that time passed.
  bool WaitForScan(std::uint64_t scans) const;

  /// From the next scan on, news have the server's map of many scans, or no longer have it.
  void WantFusedMap(bool isWanted) { this->FusedMapWanted = isWanted; }

  /// Sends the newest pose soon. If the server ends before a scan from there arrives, sends it
  /// again after the restart.
  void SendPose(const LMS3D::Pose& pose);

private:
  struct FusedMapNews
  {
    bool IsWanted = false;
    /// Null if it could not be fetched.
    lms3dRemoteFusedMapPointer Map;
    std::string Problem;
  };

  bool IsStopped() const;
  void Follow();
  void SendPendingPose(lms3dRemoteServer& server);
  void TakeRefusal(std::uint64_t number, const std::string& refusal);
  void Publish(lms3dRemoteScanPointer scan, const FusedMapNews& fusedMap);
  /// Returns the map before. The Mutex must be locked.
  lms3dRemoteFusedMapPointer ReplaceFusedMap(const FusedMapNews& fusedMap);
  FusedMapNews FetchFusedMap(lms3dRemoteServer& server) const;
  void ReportProblem(const std::string& problem);
  void Pause() const;

  const std::string Url;
  const std::chrono::milliseconds Timeout;

  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  bool Stopped = false;
  std::atomic<bool> FusedMapWanted{ false };
  lms3dRemoteNews News;
  LMS3D::Pose Pose{};
  /// Number of the newest pose, from 1.
  std::uint64_t PoseNumber = 0;

  ///@{
  /// Only for the thread of Run(): the last pose that this run of the server has answered, and the
  /// generation of its scans.
  std::uint64_t AnsweredPose = 0;
  std::uint64_t PoseGeneration = 0;
  ///@}
};

#endif
