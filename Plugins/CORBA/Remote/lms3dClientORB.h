// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ORB of this process, as a client uses it.
 */
#ifndef lms3dClientORB_h
#define lms3dClientORB_h

#include <omniORB4/CORBA.h>

/// Made by the first call and never destroyed: there is one in a process, and others may use it too.
/// Throws CORBA::SystemException.
CORBA::ORB_ptr lms3dGetClientORB();

#endif
