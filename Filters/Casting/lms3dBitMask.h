// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sets of the beams of a packet, or of sixteen tiles, as masks: bit i stands for beam or
 * tile i.
 */
#ifndef lms3dBitMask_h
#define lms3dBitMask_h

#include <bitset>
#include <cstdint>

inline bool lms3dHasBit(std::uint32_t mask, int bit)
{
  return (mask >> bit) & 1u;
}

/// Returns the number of bits that are set.
inline int lms3dCountBits(std::uint32_t mask)
{
  return static_cast<int>(std::bitset<32>(mask).count());
}

/// Returns the lowest bit of a mask that is not 0, of 32 or 64 bits.
inline int lms3dGetFirstBit(std::uint64_t mask)
{
#if defined(__GNUC__)
  return __builtin_ctzll(mask);
#else
  int first = 0;
  while ((mask >> first & 1u) == 0)
  {
    ++first;
  }
  return first;
#endif
}

#endif
