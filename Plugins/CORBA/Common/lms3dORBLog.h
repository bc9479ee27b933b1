// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ORB's log lines, and its transport for TLS.
 */
#ifndef lms3dORBLog_h
#define lms3dORBLog_h

#include <string>
#include <vector>

/**
 * Sends the ORB's log lines to `log`, in printable ASCII (see lms3dMakePrintable()), from any
 * thread; at most 20 lines per second (see lms3dLogLimit), unless the ORB's traceLevel is above 1.
 * Call once per process, before ORB_init().
 *
 * Linking this function also links omniORB's transport for TLS. The transport warns at each start
 * without certificates. The warning is dropped unless one of `settings` contains "ssl".
 */
void lms3dSetORBLog(void (*log)(const std::string& line), const std::vector<std::string>& settings);

/// Logs how many lines of the ORB were left out since the last such line, if any. Call before
/// lms3dFinishLog(). Does nothing before lms3dSetORBLog().
void lms3dFinishORBLog();

#endif
