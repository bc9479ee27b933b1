// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ORB's settings that make a server safe.
 */
#ifndef lms3dORBSettings_h
#define lms3dORBSettings_h

#include "lms3dServerOptions.h"

#include <string>
#include <utility>
#include <vector>

/// Name and value, without -ORB.
using lms3dORBSettings = std::vector<std::pair<std::string, std::string>>;

/**
 * What ORB_init() is to be given beside the arguments: the server's options, and limits for clients
 * that stall, flood or vanish. What the administrator sets in the arguments, in omniORB's environment
 * variables or in its configuration file is left out here, since omniORB would prefer these settings
 * to the latter two.
 */
lms3dORBSettings lms3dGetORBSettings(const lms3dServerOptions& options);

/// Throws std::invalid_argument where others than --endpoint say where to listen, unless other machines
/// may reach the server anyway.
void lms3dCheckEndpointSources(const lms3dServerOptions& options);

#endif
