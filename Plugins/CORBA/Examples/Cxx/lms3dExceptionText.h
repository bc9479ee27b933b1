// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Messages of CORBA's and the scanner's exceptions.
 */
#ifndef lms3dExceptionText_h
#define lms3dExceptionText_h

#include "LMS3DScanner.hh"

#include <string>

/// The name of the exception and its explanation.
std::string lms3dDescribe(const CORBA::Exception& problem);

#endif
