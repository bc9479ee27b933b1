// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where an object can be reached.
 */
#ifndef lms3dObjectAddresses_h
#define lms3dObjectAddresses_h

#include <omniORB4/CORBA.h>

#include <string>
#include <vector>

/// As omniORB writes endpoints, "giop:tcp:127.0.0.1:2810".
std::vector<std::string> lms3dGetAddresses(CORBA::Object_ptr object);

/// The URI of an object of this key, "corbaloc:iiop:1.2@127.0.0.1:2810/KEY", at the first of the
/// addresses that can be written so; empty where there is none.
std::string lms3dGetCorbaloc(const std::vector<std::string>& addresses, const std::string& key);

#endif
