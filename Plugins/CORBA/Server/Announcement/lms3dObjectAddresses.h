// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The network addresses of a CORBA object.
 */
#ifndef lms3dObjectAddresses_h
#define lms3dObjectAddresses_h

#include <omniORB4/CORBA.h>

#include <string>
#include <vector>

/// The addresses of the object's IOR in omniORB's form, such as "giop:tcp:127.0.0.1:2810".
std::vector<std::string> lms3dGetAddresses(CORBA::Object_ptr object);

/// True for TCP and TLS, the transports of the network. False for Unix sockets.
bool lms3dIsNetworkAddress(const std::string& address);

/// The URI of the object with this key, "corbaloc:iiop:1.2@127.0.0.1:2810/KEY", at the first TCP or
/// TLS address. Empty if there is none.
std::string lms3dGetCorbaloc(const std::vector<std::string>& addresses, const std::string& key);

#endif
