// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How VTK-free code reports progress and learns of an abort.
 */
#ifndef lms3dProgress_h
#define lms3dProgress_h

#include <functional>

/// Receives the share of the work that is done, 0 to 1, always on the thread that started the work.
/// Returns false to stop the work.
using lms3dProgress = std::function<bool(double)>;

#endif
