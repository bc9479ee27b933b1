// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A client's object that is told of each scan.
 */
#ifndef lms3dListener_h
#define lms3dListener_h

#include "LMS3DScanner.hh"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

/// A thread of its own tells it, so that one whose machine does not answer delays nobody else. Of the
/// scans that come while it is being told, it is told of the newest.
class lms3dListener
{
public:
  /// The address is for the log.
  lms3dListener(LMS3D::ScanListener_ptr reference, const std::string& address);
  /// Waits for the call that is under way, half a second at most.
  ~lms3dListener();
  lms3dListener(const lms3dListener&) = delete;
  void operator=(const lms3dListener&) = delete;

  const std::string& GetAddress() const { return this->Address; }

  /// Waits for nobody.
  void Tell(const LMS3D::ScanHeader& header);

  /// Begins no call any more, and does not wait for the one that is under way.
  void Stop();

  /// True where it could not be reached, and no more is tried.
  bool IsLeftOut() const;

private:
  void Run();
  /// The newest header that was not told yet; false where there is to be none any more.
  bool WaitForNews(LMS3D::ScanHeader& header);
  bool Reach(const LMS3D::ScanHeader& header) const;

  const LMS3D::ScanListener_var Reference;
  const std::string Address;
  mutable std::mutex Mutex;
  std::condition_variable Changed;
  LMS3D::ScanHeader News;
  bool HasNews = false;
  bool Stopped = false;
  bool LeftOut = false;
  std::thread Thread;
};

#endif
