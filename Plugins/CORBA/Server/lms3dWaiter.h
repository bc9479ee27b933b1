// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Counts those who wait.
 */
#ifndef lms3dWaiter_h
#define lms3dWaiter_h

#include <atomic>

/// Counts as one for as long as it lives.
class lms3dWaiter
{
public:
  explicit lms3dWaiter(std::atomic<unsigned int>& count)
    : Count(count)
    , Number(++count)
  {
  }
  ~lms3dWaiter() { --this->Count; }
  lms3dWaiter(const lms3dWaiter&) = delete;
  void operator=(const lms3dWaiter&) = delete;

  /// How many there were with this one.
  unsigned int GetNumber() const { return this->Number; }

private:
  std::atomic<unsigned int>& Count;
  const unsigned int Number;
};

#endif
