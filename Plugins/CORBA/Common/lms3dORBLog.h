// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the ORB has to say, with its transport for TLS.
 */
#ifndef lms3dORBLog_h
#define lms3dORBLog_h

#include <string>
#include <vector>

/**
 * Sends the ORB's lines to `log`; to be called before ORB_init(). The transport for TLS, which a
 * program that calls this has, complains at every start that has no certificates: unless a setting
 * speaks of TLS that is left out.
 */
void lms3dSetORBLog(void (*log)(const std::string& line), const std::vector<std::string>& settings);

#endif
