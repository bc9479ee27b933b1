// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The settings of the ORB that limit what clients can do to the server.
 */
#ifndef lms3dORBSettings_h
#define lms3dORBSettings_h

#include "Options/lms3dServerOptions.h"

#include <string>
#include <utility>
#include <vector>

/// Pairs of a name, without -ORB, and a value. A name may occur more than once.
using lms3dORBSettings = std::vector<std::pair<std::string, std::string>>;

/**
 * Returns the settings for ORB_init() that follow from the server's options, and limits for clients
 * that stall, flood or vanish. A setting of the administrator, in the arguments, in omniORB's
 * environment variables or in its configuration file, is left out: otherwise omniORB would prefer
 * the returned one to the environment's and the file's. Reads the environment, so it is not
 * thread-safe against setenv().
 */
lms3dORBSettings lms3dGetORBSettings(const lms3dServerOptions& options);

/// Throws std::invalid_argument if the administrator's settings of the ORB name an endpoint, unless
/// --allow-remote is given.
void lms3dCheckEndpointSources(const lms3dServerOptions& options);

#endif
