// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vector with an entry for each beam of a scan.
 *
 * The C library returns memory of this size to the system, and gets it again for the next map, page
 * by page. That would take a tenth of the time of a map. TBB's allocator keeps the memory.
 */
#ifndef lms3dBeamVector_h
#define lms3dBeamVector_h

#include <tbb/tbb_allocator.h>

#include <vector>

template <typename T>
using lms3dBeamVector = std::vector<T, tbb::tbb_allocator<T>>;

#endif
