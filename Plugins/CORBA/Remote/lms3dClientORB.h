// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ORB of this process, for clients.
 */
#ifndef lms3dClientORB_h
#define lms3dClientORB_h

#include <omniORB4/CORBA.h>

/// The first call creates the ORB. It is never destroyed, because a process has only one, and other
/// code may use it too. The caller does not own the result. Any thread. Throws
/// CORBA::SystemException.
CORBA::ORB_ptr lms3dGetClientORB();

#endif
