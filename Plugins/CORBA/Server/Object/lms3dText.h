// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Text for clients.
 */
#ifndef lms3dText_h
#define lms3dText_h

#include <omniORB4/CORBA.h>

#include <string>

/// A copy within the bounds of LMS3D::Text, of printable ASCII alone, which every ORB takes.
CORBA::String_var lms3dText(const std::string& text);

#endif
