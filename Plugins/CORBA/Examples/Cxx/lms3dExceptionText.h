// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Exceptions of CORBA and of the scanner in words.
 */
#ifndef lms3dExceptionText_h
#define lms3dExceptionText_h

#include "LMS3DScanner.hh"

#include <string>

/// An exception's name and what it tells.
std::string lms3dDescribe(const CORBA::Exception& problem);

#endif
