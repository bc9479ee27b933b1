// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the scanner's object from a reference that a user writes.
 */
#ifndef lms3dScannerReference_h
#define lms3dScannerReference_h

#include "LMS3DScanner.hh"

#include <string>

/**
 * `reference` is an IOR, a corbaloc, a corbaname, or the path of a file that contains one of these,
 * with or without "file:" before the path. `timeout` limits each call to the scanner, also later
 * ones, and to the naming service, in milliseconds; 0 leaves the ORB's own limit. The caller owns
 * the result. Throws std::runtime_error if the reference names no scanner, and
 * CORBA::SystemException if no server answers.
 */
LMS3D::LaserScanner_ptr lms3dFindScanner(
  CORBA::ORB_ptr orb, const std::string& reference, CORBA::ULong timeout = 0);

#endif
