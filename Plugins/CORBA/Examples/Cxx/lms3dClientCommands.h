// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What lms3d-client can do.
 */
#ifndef lms3dClientCommands_h
#define lms3dClientCommands_h

#include "LMS3DScanner.hh"

#include <functional>
#include <string>
#include <vector>

std::string lms3dGetClientHelp();

/// What is to be done with a scanner. Throws CORBA::Exception and std::runtime_error.
using lms3dClientCommand = std::function<void(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr)>;

/// Needs no scanner. Empty where there is no such command, or not with so many words. Throws
/// std::invalid_argument for a word that cannot be taken, std::runtime_error for a file that cannot
/// be written.
lms3dClientCommand lms3dReadClientCommand(
  const std::string& name, const std::vector<std::string>& words);

#endif
