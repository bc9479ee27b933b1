// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeConfiguration.h"

#include <cstring>

const char* lms3dGetEmbreeConfiguration(const lms3dPacketKernels& kernels)
{
  if (&kernels == &lms3dGetPacketKernels(lms3dGetNumberOfPacketKernels() - 1))
  {
    return nullptr;
  }
  return std::strcmp(kernels.Name, "AVX2") == 0 ? "max_isa=avx2" : "max_isa=sse2";
}
