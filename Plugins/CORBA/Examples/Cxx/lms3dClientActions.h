// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the commands of lms3d-client do with a scanner.
 */
#ifndef lms3dClientActions_h
#define lms3dClientActions_h

#include "LMS3DScanner.hh"

#include <optional>
#include <string>
#include <vector>

// All throw CORBA::Exception, and std::runtime_error if the server cannot scan, has restarted or
// sends invalid data.

/// Throws std::runtime_error if the standard output cannot be written, e.g. because the disk is
/// full.
void lms3dRequireOutput();

/// Waits for a scan whose number is above `after`, and returns its number.
CORBA::ULongLong lms3dWaitForNextScan(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after);

/// Prints a line about a scan.
void lms3dPrintHeader(const LMS3D::ScanHeader& header);

/// Waits for the first scan of a generation, and prints a line about it.
void lms3dPrintFirst(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong generation);

/// Prints what the server does, and its newest scan.
void lms3dPrintStatus(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner);

/// Prints the names of all scenes.
void lms3dPrintScenes(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner);

/// Prints range (metres), alpha and beta (degrees) of each beam, with the paper's fetch().
void lms3dPrintBeams(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner);

/// Saves the newest scan to files[0] and, if there is files[1], its local map to that.
void lms3dSaveScan(LMS3D::LaserScanner_ptr scanner, const std::vector<std::string>& files);

/// Prints a line for each of the next `count` scans.
void lms3dWatchScans(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong count);

/// Moves the sensor and prints the first scan from there. Metres and degrees; without `orientation`
/// only the position changes.
void lms3dMoveSensor(LMS3D::LaserScanner_ptr scanner, const LMS3D::Vector3& position,
  const std::optional<LMS3D::Vector3>& orientation);

/// Selects a scene and prints its first scan.
void lms3dSelectScene(LMS3D::LaserScanner_ptr scanner, const std::string& name);

#endif
