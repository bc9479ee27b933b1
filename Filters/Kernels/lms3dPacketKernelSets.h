// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels of this build, one set for each instruction set.
 */
#ifndef lms3dPacketKernelSets_h
#define lms3dPacketKernelSets_h

#include "Kernels/lms3dPacketKernels.h"

extern const lms3dPacketKernels lms3dPacketKernelsBaseline;
#ifdef LMS3D_X86_KERNELS
extern const lms3dPacketKernels lms3dPacketKernelsAVX2;
extern const lms3dPacketKernels lms3dPacketKernelsAVX512;
#endif

#endif
