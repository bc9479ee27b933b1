// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The commands of lms3d-client about the map of many scans.
 */
#ifndef lms3dClientFusedMap_h
#define lms3dClientFusedMap_h

#include "LMS3DScanner.hh"

#include <string>

// The following throw what the functions of lms3dClientActions.h throw, and LMS3D::NoFusedMap.

/// Saves the map to a file.
void lms3dSaveFusedMap(LMS3D::LaserScanner_ptr scanner, const std::string& file);

/// Prints a line for each of the next `count` states of the map, the newest one first. Fetches only
/// what changes.
void lms3dWatchFusedMap(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong count);

/// Begins a new map, and prints the first scan of it.
void lms3dResetFusedMap(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner);

#endif
