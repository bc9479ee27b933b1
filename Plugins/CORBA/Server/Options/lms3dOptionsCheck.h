// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Refuses options of lms3d-server that contradict one another or let other machines in.
 */
#ifndef lms3dOptionsCheck_h
#define lms3dOptionsCheck_h

#include <string>

struct lms3dServerOptions;

/// Throws std::invalid_argument with the option, the wrong value and what is expected.
void lms3dCheckServerOptions(const lms3dServerOptions& options);

/// Returns true if no other machine can connect to `endpoint`, "giop:TRANSPORT:HOST:PORT".
bool lms3dIsLocalEndpoint(const std::string& endpoint);

#endif
