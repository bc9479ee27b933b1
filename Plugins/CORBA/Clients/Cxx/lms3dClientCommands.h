// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What lms3d-client can do.
 */
#ifndef lms3dClientCommands_h
#define lms3dClientCommands_h

#include "LMS3DScanner.hh"

#include <string>
#include <vector>

std::string lms3dGetClientHelp();

/// False where there is no such command, or not with so many words. Throws std::invalid_argument for a
/// word that cannot be taken, and what else goes wrong.
bool lms3dRunClientCommand(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner,
  const std::string& name, const std::vector<std::string>& words);

#endif
