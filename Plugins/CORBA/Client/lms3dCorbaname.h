// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Objects by their names in a naming service.
 */
#ifndef lms3dCorbaname_h
#define lms3dCorbaname_h

#include <omniORB4/CORBA.h>

#include <string>

bool lms3dIsCorbaname(const std::string& url);

/// The object of a corbaname, which the ORB finds too, but takes as long as the naming service does:
/// this one's answer may take `timeout` milliseconds, with 0 as long as the ORB lets it. Throws
/// CORBA::BAD_PARAM where the service has no such name, or the URL is none, and
/// CORBA::SystemException where nobody answers.
CORBA::Object_ptr lms3dFindByName(
  CORBA::ORB_ptr orb, const std::string& corbaname, CORBA::ULong timeout);

#endif
