// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tells objects apart, even if one stands where another one stood before.
 */
#ifndef lms3dSerialNumber_h
#define lms3dSerialNumber_h

#include <atomic>
#include <cstdint>

/// Returns a number that no earlier call of this process returned, from 1 on. Several threads may
/// call this at once.
inline std::uint64_t lms3dMakeSerialNumber()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

#endif
