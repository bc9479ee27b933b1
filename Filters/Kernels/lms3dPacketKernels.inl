// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels; included once by the source of each instruction set.
 *
 * Plain loops over arrays, which compilers turn into vector instructions. Nothing here may be an
 * inline function that other sources share: the linker would keep one of them, perhaps the one that
 * the processor cannot run.
 */
#ifndef lms3dPacketKernels_inl
#define lms3dPacketKernels_inl

#include "Kernels/lms3dBeamKernels.inl"
#include "Kernels/lms3dInsideKernels.inl"
#include "Kernels/lms3dNormalKernels.inl"
#include "Kernels/lms3dRangeKernels.inl"

// In the order of lms3dPacketKernels.
#define LMS3D_PACKET_KERNELS                                                                   \
  Aim, FindWithin, SetStarts, Classify, TakeHits, Shorten, FindHits, See, SeeRoughly, Measure, \
    MeasureRoughly, KeepRanges, Finish, Locate, AddStrip

#endif
