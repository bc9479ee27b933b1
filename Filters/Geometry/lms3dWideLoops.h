// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compiles a function once for each set of vector instructions.
 *
 * LMS3D_WIDE_LOOPS stands before the definition of a function with a loop that the compiler turns
 * into vectors. The program takes the widest vectors that the processor has, and results are the
 * same to the bit: with LMS3D_FLOATING_POINT_OPTIONS the compiler neither reorders sums nor
 * contracts products with sums. What needs more than loops is in the room Kernels.
 *
 * Other compilers, C libraries and processors make one function. So do sanitizers, whose memory is
 * not yet prepared when the program chooses.
 */
#ifndef lms3dWideLoops_h
#define lms3dWideLoops_h

#include <cstddef>

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 && \
  !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LMS3D_WIDE_LOOPS \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define LMS3D_WIDE_LOOPS
#endif

#endif
