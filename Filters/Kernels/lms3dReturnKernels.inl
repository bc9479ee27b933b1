// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels that fill the arrays of returns.
 */
#ifndef lms3dReturnKernels_inl
#define lms3dReturnKernels_inl

#include "Kernels/lms3dPacketMask.inl"
#include "Kernels/lms3dReturnArrays.h"

namespace
{
// In all loops, the outputs must not overlap the input, so that the compiler can vectorize them.

void FillNumbers(std::int32_t first, int count, std::int32_t* __restrict numbers)
{
  for (int i = 0; i < count; ++i)
  {
    numbers[i] = first + i;
  }
}

void FillReturnRun(const lms3dReturnRunArrays& run)
{
  const int count = run.Count;
  const double* const ranges = run.Ranges;
  if (run.Range != ranges)
  {
    double* const __restrict range = run.Range;
    for (int i = 0; i < count; ++i)
    {
      range[i] = ranges[i];
    }
  }
  const double* const elevations = run.Elevations;
  float* const __restrict alpha = run.Alpha;
  for (int i = 0; i < count; ++i)
  {
    alpha[i] = static_cast<float>(elevations[i]);
  }
  const float angle = run.Angle;
  float* const __restrict beta = run.Beta;
  for (int i = 0; i < count; ++i)
  {
    beta[i] = angle;
  }
  FillNumbers(run.FirstBeam, count, run.BeamId);
  FillNumbers(run.FirstSlot, count, run.Offset);
  FillNumbers(run.FirstSlot, count, run.Point);
}

void WidenTriangles(const std::int32_t* triangles, int count, long long* __restrict cells)
{
  for (int i = 0; i < count; ++i)
  {
    cells[i] = triangles[i];
  }
}

int CountReturns(const std::int32_t* triangles, int count)
{
  // As wide as the triangles, so that the compiler can vectorize the loop.
  std::int32_t returns = 0;
  for (int i = 0; i < count; ++i)
  {
    returns += triangles[i] != lms3dBeamPacket::NoTriangle ? 1 : 0;
  }
  return returns;
}
} // namespace

#endif
