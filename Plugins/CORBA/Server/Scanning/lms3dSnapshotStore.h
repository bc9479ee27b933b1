// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finished scans, for any number of readers.
 */
#ifndef lms3dSnapshotStore_h
#define lms3dSnapshotStore_h

#include "Common/lms3dScanData.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

/// A finished scan. It does not change after it is published.
struct lms3dSnapshot : lms3dScanData
{
  ///@{
  /// Seconds that the scan and its map took.
  double ScanSeconds = 0.0;
  double MapSeconds = 0.0;
  ///@}

  /// The memory of the arrays.
  std::size_t GetBytes() const
  {
    return sizeof(float) * this->Ranges.size() + this->Statuses.size() +
      sizeof(double) * this->MapPoints.size() + sizeof(std::uint32_t) * this->MapTriangles.size();
  }
};

using lms3dSnapshotPointer = std::shared_ptr<const lms3dSnapshot>;

/**
 * Keeps the newest scans. Readers share a snapshot and hold no lock while they use it, so the
 * scanner never waits for a reader. The last reader frees the snapshot. All methods may be called
 * from any thread.
 */
class lms3dSnapshotStore
{
public:
  using Clock = std::chrono::steady_clock;

  /// 1 GiB: five scans of the maximum number of beams with every return in the map.
  static constexpr std::size_t DefaultMaximumBytes = std::size_t(1) << 30;

  /// Keeps the newest `keep` scans (at least 1), or fewer if they exceed `maximumBytes` together.
  /// The newest scan always stays.
  explicit lms3dSnapshotStore(std::size_t keep, std::size_t maximumBytes = DefaultMaximumBytes);

  /// Adds a scan, whose number must be one more than the number of the scan before.
  void Publish(lms3dSnapshotPointer snapshot);

  /// Null before the first scan.
  lms3dSnapshotPointer GetNewest() const;

  ///@{
  /// 0 before the first scan.
  std::uint64_t GetNewestNumber() const;
  std::uint64_t GetOldestNumber() const;
  ///@}

  /// The memory of all scans that are kept.
  std::size_t GetBytes() const;

  /// The scan with this number. Null if it does not exist or was dropped.
  lms3dSnapshotPointer Find(std::uint64_t number) const;

  /// Waits until the number of the newest scan is above `after` and its generation at least
  /// `generation`, and returns it. Returns null after the deadline, and at once after Stop().
  lms3dSnapshotPointer Wait(
    std::uint64_t after, std::uint64_t generation, Clock::time_point deadline) const;

  /// Ends all current and later calls of Wait().
  void Stop();
  bool IsStopped() const;

private:
  bool HasNewest(std::uint64_t after, std::uint64_t generation) const;
  bool IsOverLimit() const;

  const std::size_t Keep;
  const std::size_t MaximumBytes;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  std::deque<lms3dSnapshotPointer> Snapshots;
  std::size_t Bytes = 0;
  bool Stopped = false;
};

#endif
