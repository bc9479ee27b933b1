// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The server's entry in a naming service.
 */
#ifndef lms3dNameRegistration_h
#define lms3dNameRegistration_h

#include <omniORB4/CORBA.h>

#include <string>

/// Is there while this lives, which must end before the ORB does. Where the naming service cannot be
/// reached the log says so, and clients take the reference or the corbaloc.
class lms3dNameRegistration
{
public:
  /// `service` is a URI, or empty for that which the ORB knows. `name` is stringified, as
  /// "LMS3D.Scanner" or "robots/LMS3D.Scanner", in contexts that exist.
  lms3dNameRegistration(CORBA::ORB_ptr orb, const std::string& service, const std::string& name,
    CORBA::Object_ptr object);
  ~lms3dNameRegistration();
  lms3dNameRegistration(const lms3dNameRegistration&) = delete;
  void operator=(const lms3dNameRegistration&) = delete;

private:
  const std::string Name;
  const CORBA::Object_var Object;
  CosNaming::NamingContextExt_var Context;
};

#endif
