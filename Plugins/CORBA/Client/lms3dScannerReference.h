// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From what a user writes to the scanner's object.
 */
#ifndef lms3dScannerReference_h
#define lms3dScannerReference_h

#include "LMS3DScanner.hh"

#include <string>

/// `reference` is an IOR, a corbaloc, a corbaname, or the name of a file that has one of these, with
/// "file:" before it or without. Throws std::runtime_error where it leads to no scanner,
/// CORBA::SystemException where nobody answers. Calls to the scanner, this one's included, and to the
/// naming service take no longer than so many milliseconds each; with 0 as long as the ORB lets them.
LMS3D::LaserScanner_ptr lms3dFindScanner(
  CORBA::ORB_ptr orb, const std::string& reference, CORBA::ULong timeout = 0);

#endif
