// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Masks of beams and small functions that all packet kernels use.
 */
#ifndef lms3dPacketMask_inl
#define lms3dPacketMask_inl

#include "Kernels/lms3dPacketKernels.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace
{
constexpr int Size = lms3dBeamPacket::Size;

double Magnitude(double x)
{
  return x < 0.0 ? -x : x;
}

template <typename Real>
Real Minimum(Real x, Real y)
{
  return x < y ? x : y;
}

template <typename Real>
Real Maximum(Real x, Real y)
{
  return x > y ? x : y;
}

// The product of vector i of sixteen with one other vector.
template <typename Real>
Real Dot(const Real (&x)[3][Size], int i, const Real* y)
{
  return x[0][i] * y[0] + x[1][i] * y[1] + x[2][i] * y[2];
}

// A condition for each beam: -1 (all bits set) or 0.
struct Mask
{
  void Set(int beam, bool condition) { this->Beams[beam] = condition ? -1 : 0; }

  // Returns bit i for beam i. Compilers turn a plain loop into a slow tree of shifts.
  std::uint32_t GetBits() const
  {
#if defined(__AVX512DQ__)
    return _mm512_movepi32_mask(_mm512_load_si512(this->Beams));
#elif defined(__SSE2__)
    std::uint32_t bits = 0;
    for (int i = 0; i < Size; i += 4)
    {
      const __m128i* four = reinterpret_cast<const __m128i*>(this->Beams + i);
      bits |= static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(_mm_load_si128(four))))
        << i;
    }
    return bits;
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < Size; ++i)
    {
      bits |= this->Beams[i] ? 1u << i : 0u;
    }
    return bits;
#endif
  }

  alignas(64) std::int32_t Beams[Size];
};
} // namespace

#endif
