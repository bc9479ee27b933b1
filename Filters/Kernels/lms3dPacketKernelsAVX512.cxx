// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Kernels/lms3dPacketKernels.inl"

#include "Kernels/lms3dPacketKernelSets.h"

const lms3dPacketKernels lms3dPacketKernelsAVX512 = { "AVX512", 16, LMS3D_PACKET_KERNELS };
