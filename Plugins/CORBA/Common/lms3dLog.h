// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The server's log.
 */
#ifndef lms3dLog_h
#define lms3dLog_h

#include <string>

/// Writes the time in UTC and a line of text to the standard error. Any thread.
void lms3dLog(const std::string& text);

#endif
