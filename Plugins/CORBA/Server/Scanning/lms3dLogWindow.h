// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sends VTK's messages to the log.
 */
#ifndef lms3dLogWindow_h
#define lms3dLogWindow_h

/// Sends the messages that VTK prints to the standard error, because no observer collects them, to
/// lms3dLog() instead. For the whole process.
void lms3dLogVTKMessages();

#endif
