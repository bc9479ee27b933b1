// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Limits the calls that wait: for a scan, or for their turn.
 */
#ifndef lms3dWaitingRoom_h
#define lms3dWaitingRoom_h

#include "Connections/lms3dRequestGate.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>

/// Occupies one of a limited number of places as long as this object lives.
class lms3dLimitedCall
{
public:
  /// Throws LMS3D::LimitExceeded with `reason` if `count` has reached `maximum`. `count` must
  /// outlive this object. Any thread.
  lms3dLimitedCall(std::atomic<unsigned int>& count, unsigned int maximum, const char* reason);
  ~lms3dLimitedCall() { --this->Count; }
  lms3dLimitedCall(const lms3dLimitedCall&) = delete;
  void operator=(const lms3dLimitedCall&) = delete;

private:
  std::atomic<unsigned int>& Count;
};

/// The calls that wait for a scan. If the client of a call disconnects, its place is free again
/// within a second. All methods may be called from any thread.
class lms3dWaitingRoom
{
public:
  static constexpr unsigned int MaximumCalls = 32;
  /// One less than the ORB's threads of a connection. The last thread notices the end of the
  /// connection.
  static constexpr unsigned int MaximumCallsPerConnection = 3;

  /// `store` must outlive this object.
  explicit lms3dWaitingRoom(const lms3dSnapshotStore& store);

  /// As lms3dSnapshotStore::Wait(), up to `timeout`. Also returns null if the calling client
  /// disconnects. Throws LMS3D::LimitExceeded if there is no such scan yet and no place to wait for
  /// it.
  lms3dSnapshotPointer Wait(
    std::uint64_t after, std::uint64_t generation, std::chrono::milliseconds timeout);

  /// The newest scan. Waits for the first one, and throws CORBA::TRANSIENT if it does not come in
  /// time or there is no place to wait for it.
  lms3dSnapshotPointer WaitForFirst();

  /// The number of waiting calls.
  std::size_t GetNumber() const;

private:
  class WaitingCall;

  const lms3dSnapshotStore& Store;
  mutable std::mutex Mutex;
  /// The connections of the waiting calls.
  std::multiset<const omni::giopStrand*> Waiting;
};

#endif
