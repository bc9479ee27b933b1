// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Counts those who wait, and lets in as many as may.
 */
#ifndef lms3dWaiter_h
#define lms3dWaiter_h

#include "LMS3DScanner.hh"

#include <atomic>

/// Counts as one for as long as it lives.
class lms3dWaiter
{
public:
  /// Throws LMS3D::LimitExceeded, with that reason, where there are `most` already.
  lms3dWaiter(std::atomic<unsigned int>& count, unsigned int most, const char* reason)
    : Count(count)
  {
    unsigned int others = count;
    do
    {
      if (others >= most)
      {
        throw LMS3D::LimitExceeded(reason, most);
      }
    } while (!count.compare_exchange_weak(others, others + 1));
  }
  ~lms3dWaiter() { --this->Count; }
  lms3dWaiter(const lms3dWaiter&) = delete;
  void operator=(const lms3dWaiter&) = delete;

private:
  std::atomic<unsigned int>& Count;
};

#endif
