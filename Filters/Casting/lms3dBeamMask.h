// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sets of beams of a packet as masks: bit i stands for beam i.
 */
#ifndef lms3dBeamMask_h
#define lms3dBeamMask_h

#include <cstdint>

inline bool lms3dHasBeam(std::uint32_t beams, int beam)
{
  return (beams >> beam) & 1u;
}

/// Returns the first beam of a set that is not empty.
inline int lms3dGetFirstBeam(std::uint32_t beams)
{
#if defined(__GNUC__)
  return __builtin_ctz(beams);
#else
  int first = 0;
  while (!lms3dHasBeam(beams, first))
  {
    ++first;
  }
  return first;
#endif
}

#endif
