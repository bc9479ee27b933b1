// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ORB of the test program, and common calls of tests.
 */
#ifndef ClientORB_h
#define ClientORB_h

#include "LMS3DScanner.hh"

#include <string>

CORBA::ORB_ptr GetClientORB();

LMS3D::LaserScanner_var Connect(const std::string& reference);

/// Waits for the newest scan of a generation, by default any, with a number above `after`. Fails
/// the test if none comes within a minute.
LMS3D::ScanHeader WaitFor(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong generation = 0, CORBA::ULongLong after = 0);

/// A pose without rotation.
LMS3D::Pose At(double x, double y, double z);

/// A smaller grid, for tests that are not about the scan.
LMS3D::Configuration GetCoarseGrid();

#endif
