// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A client's object that the server calls for each scan.
 */
#ifndef lms3dListener_h
#define lms3dListener_h

#include "LMS3DScanner.hh"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

/// Calls the object in a thread of its own, so that one that does not answer delays no other. Of
/// the scans that come during a call, only the newest is passed on. All methods may be called from
/// any thread.
class lms3dListener
{
public:
  /// `address` is for the log. Starts the thread.
  lms3dListener(LMS3D::ScanListener_ptr reference, const std::string& address);
  /// Waits for the current call; see HasEnded().
  ~lms3dListener();
  lms3dListener(const lms3dListener&) = delete;
  void operator=(const lms3dListener&) = delete;

  const std::string& GetAddress() const { return this->Address; }

  /// Passes a header to the thread and returns at once.
  void Notify(const LMS3D::ScanHeader& header);

  /// Begins no further calls. Does not wait for the current one.
  void Stop();

  /// True if three calls in a row failed. No more calls are made then.
  bool HasFailed() const;

  /// True if no call is made any more, so that the destructor returns at once. After Stop() a
  /// current call takes half a second at most, and the lookup of a host's name as long as the
  /// system needs.
  bool HasEnded() const;

private:
  void Run();
  /// Calls until Stop(), or until the object has failed. Returns true in the second case.
  bool CallUntilFailure();
  /// Waits for a header that was not passed on yet. Returns false after Stop().
  bool WaitForHeader(LMS3D::ScanHeader& header);
  /// Returns false if the object cannot be reached. `isRetry` if the call before failed.
  bool Call(const LMS3D::ScanHeader& header, bool isRetry);

  /// For the thread alone.
  LMS3D::ScanListener_var Reference;
  const std::string Address;
  mutable std::mutex Mutex;
  std::condition_variable Changed;
  LMS3D::ScanHeader Newest;
  bool IsPending = false;
  bool Stopped = false;
  bool Failed = false;
  bool Ended = false;
  std::thread Thread;
};

#endif
