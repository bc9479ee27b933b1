// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The commands of lms3d-client.
 */
#ifndef lms3dClientCommands_h
#define lms3dClientCommands_h

#include "LMS3DScanner.hh"

#include <functional>
#include <string>
#include <vector>

/// The text of --help.
std::string lms3dGetClientHelp();

/// A command with its arguments. Throws CORBA::Exception and std::runtime_error.
using lms3dClientCommand = std::function<void(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr)>;

/**
 * Reads a command and its arguments without contacting a scanner. Returns an empty function if the
 * command does not exist or takes another number of arguments. Throws std::invalid_argument for an
 * invalid number, and std::runtime_error for a file that cannot be written.
 */
lms3dClientCommand lms3dReadClientCommand(
  const std::string& name, const std::vector<std::string>& words);

#endif
