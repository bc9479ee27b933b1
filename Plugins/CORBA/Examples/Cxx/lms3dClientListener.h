// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A listener, which the server calls for each scan.
 */
#ifndef lms3dClientListener_h
#define lms3dClientListener_h

#include "LMS3DScanner.hh"

#include <functional>

/// Subscribes a listener, passes `count` headers to `use` in the calling thread, and unsubscribes.
/// Throws CORBA::SystemException if the server ends meanwhile, std::runtime_error if the server has
/// lost the listener or cannot reach it.
void lms3dListenToScanner(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner,
  CORBA::ULongLong count, const std::function<void(const LMS3D::ScanHeader&)>& use);

#endif
