// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An object of the client that the server tells of scans.
 */
#ifndef lms3dClientListener_h
#define lms3dClientListener_h

#include "LMS3DScanner.hh"

#include <functional>

/// Subscribes, hands `count` headers to `use`, and unsubscribes. Throws CORBA::SystemException
/// where the server is gone meanwhile, std::runtime_error where it does not know, or does not
/// reach, the listener.
void lms3dListenToScanner(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner,
  CORBA::ULongLong count, const std::function<void(const LMS3D::ScanHeader&)>& use);

#endif
