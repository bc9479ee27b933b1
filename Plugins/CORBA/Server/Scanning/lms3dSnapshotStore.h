// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The newest scans, for any number of readers.
 */
#ifndef lms3dSnapshotStore_h
#define lms3dSnapshotStore_h

#include "lms3dSnapshot.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>

/**
 * Readers share snapshots and never hold the lock while they use one, so that the scanner waits for
 * none of them; a snapshot lives as long as somebody reads it.
 */
class lms3dSnapshotStore
{
public:
  using Clock = std::chrono::steady_clock;

  /// 1 GiB: five scans of the most beams with every return in the map.
  static constexpr std::size_t DefaultMostBytes = std::size_t(1) << 30;

  /// Keeps the newest `keep` scans, at least 1; fewer where they are more than `mostBytes` together,
  /// but always the newest.
  explicit lms3dSnapshotStore(std::size_t keep, std::size_t mostBytes = DefaultMostBytes);

  /// Numbers must grow by one from scan to scan.
  void Publish(lms3dSnapshotPointer snapshot);

  /// Null before the first scan.
  lms3dSnapshotPointer GetNewest() const;

  /// 0 before the first scan.
  std::uint64_t GetNewestNumber() const;
  std::uint64_t GetOldestNumber() const;

  /// The scan of a number; null where there is none, or no more.
  lms3dSnapshotPointer Find(std::uint64_t number) const;

  /// The newest scan as soon as its number is above `after` and its generation at least `generation`;
  /// null after the deadline, and at once after Stop().
  lms3dSnapshotPointer Wait(
    std::uint64_t after, std::uint64_t generation, Clock::time_point deadline) const;

  /// Ends all waiting, now and from now on.
  void Stop();
  bool IsStopped() const;

private:
  bool HasNewest(std::uint64_t after, std::uint64_t generation) const;
  bool HasTooMuch() const;

  const std::size_t Keep;
  const std::size_t MostBytes;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  std::deque<lms3dSnapshotPointer> Snapshots;
  std::size_t Bytes = 0;
  bool Stopped = false;
};

#endif
