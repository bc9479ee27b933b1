// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Clients that wait for a scan, as many as may.
 */
#ifndef lms3dWaitingRoom_h
#define lms3dWaitingRoom_h

#include "lms3dCaller.h"
#include "lms3dSnapshotStore.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>

/// A client that has gone is noticed and its place is free again within a second.
class lms3dWaitingRoom
{
public:
  static constexpr unsigned int Most = 32;
  /// One less than the threads that the ORB has for a connection, of which the last sees its end.
  static constexpr unsigned int MostOfConnection = 3;

  explicit lms3dWaitingRoom(const lms3dSnapshotStore& store);

  /// As that of lms3dSnapshotStore; null also where the calling client has gone. Throws
  /// LMS3D::LimitExceeded where there is no such scan yet and no place to wait for it.
  lms3dSnapshotPointer Wait(
    std::uint64_t after, std::uint64_t generation, std::chrono::milliseconds longest);

  /// The newest scan, be it that it is waited for. Throws CORBA::TRANSIENT where there is none in time.
  lms3dSnapshotPointer WaitForFirst();

  std::size_t GetNumber() const;

private:
  /// Taken as long as it lives.
  class Place;

  const lms3dSnapshotStore& Store;
  mutable std::mutex Mutex;
  /// The connections of those who wait.
  std::multiset<const omni::giopStrand*> Waiting;
};

#endif
