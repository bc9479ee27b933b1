// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The newest states of the map of many scans, for any number of readers.
 */
#ifndef lms3dFusedMapStore_h
#define lms3dFusedMapStore_h

#include "Scanning/lms3dFusedMapState.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

/// Readers share a state and hold no lock while they use it. All methods may be called from any
/// thread.
class lms3dFusedMapStore
{
public:
  /// At least this many states are kept, within the memory.
  static constexpr std::size_t MinimumKeep = 32;
  static constexpr std::size_t DefaultMaximumBytes = std::size_t(1) << 28;

  /// Keeps the newest `keep` states, or fewer if they exceed `maximumBytes` together. The newest
  /// always stays.
  explicit lms3dFusedMapStore(std::size_t keep, std::size_t maximumBytes = DefaultMaximumBytes);

  /// Adds a state, whose number must be one more than the number of the state before.
  void Publish(lms3dFusedMapPointer state);

  /// Null before the first state.
  lms3dFusedMapPointer GetNewest() const;

  /// Null if the state does not exist or was dropped.
  lms3dFusedMapPointer Find(std::uint64_t number) const;

  ///@{
  /// 0 before the first state.
  std::uint64_t GetOldestNumber() const;
  std::uint64_t GetNewestNumber() const;
  ///@}

  ///@{
  /// Why the newest scans are not in the map. Empty if they are.
  void SetProblem(const std::string& problem);
  std::string GetProblem() const;
  ///@}

private:
  bool IsOverLimit() const;

  const std::size_t Keep;
  const std::size_t MaximumBytes;
  mutable std::mutex Mutex;
  std::deque<lms3dFusedMapPointer> States;
  std::size_t Bytes = 0;
  std::string Problem;
};

#endif
