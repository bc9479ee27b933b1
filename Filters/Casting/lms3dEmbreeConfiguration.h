// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Restricts Embree to the instruction set of the packet kernels.
 */
#ifndef lms3dEmbreeConfiguration_h
#define lms3dEmbreeConfiguration_h

#include "Kernels/lms3dPacketKernels.h"

/**
 * Returns the configuration of Embree's devices for some kernels. With the processor's widest
 * kernels it is null, so that Embree chooses its instruction set. With narrower kernels it limits
 * Embree to their set, so that measurements are valid for a processor without the wider sets.
 */
const char* lms3dGetEmbreeConfiguration(
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels());

#endif
