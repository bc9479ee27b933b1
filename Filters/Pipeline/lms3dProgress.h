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

/// Returns the progress of one step of some work: the step's 0 to 1 become `first` to `last` of
/// `whole`, which must outlive the result.
inline lms3dProgress lms3dGetStepProgress(const lms3dProgress& whole, double first, double last)
{
  return [&whole, first, last](double done) { return whole(first + done * (last - first)); };
}

#endif
