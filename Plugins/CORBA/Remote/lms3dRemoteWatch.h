// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Follows a server, in a thread of its own.
 */
#ifndef lms3dRemoteWatch_h
#define lms3dRemoteWatch_h

#include "lms3dRemoteServer.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

/// What is known of a server.
struct lms3dRemoteNews
{
  /// Grows with each change of the others; 0 as long as there was none.
  std::uint64_t Count = 0;
  /// The newest scan; null before the first.
  lms3dRemoteScanPointer Scan;
  /// Why there are no newer ones; empty while they come.
  std::string Problem;
  /// Why the last pose was not taken; empty where it was, or may yet be.
  std::string Refusal;
  /// The last pose was neither refused, nor is the scan from there.
  bool IsPosePending = false;
};

/**
 * One thread runs this and talks to the server; all others look at the news and never wait for the
 * network. The server may come and go: whatever fails is a problem, and is tried again.
 */
class lms3dRemoteWatch
{
public:
  /// `timeout` is what a call may take.
  lms3dRemoteWatch(std::string url, std::chrono::milliseconds timeout);

  /// Follows the server until Stop(), which may be as late as the timeout.
  void Run();

  /// Returns at once.
  void Stop();

  std::uint64_t GetCount() const;
  lms3dRemoteNews GetNews() const;

  /// The first scan or problem, for which it waits up to the timeout; later ones at once.
  lms3dRemoteNews WaitForNews() const;

  /// To be sent soon, and again to a server that is gone before a scan comes from there. Only the newest
  /// counts.
  void SendPose(const LMS3D::Pose& pose);

private:
  bool IsStopped() const;
  void Follow();
  void SendWaitingPose(lms3dRemoteServer& server);
  void TakeRefusal(std::uint64_t number, const std::string& refusal);
  void Publish(lms3dRemoteScanPointer scan);
  void Report(std::string& place, const std::string& text);
  void Pause() const;

  const std::string Url;
  const std::chrono::milliseconds Timeout;

  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  bool Stopped = false;
  lms3dRemoteNews News;
  LMS3D::Pose Pose{};
  /// Of the newest pose, from 1.
  std::uint64_t PoseNumber = 0;

  /// Of the thread alone: the last pose that this run of the server has answered, and its scans'
  /// generation.
  std::uint64_t AnsweredPose = 0;
  std::uint64_t PoseGeneration = 0;
};

#endif
