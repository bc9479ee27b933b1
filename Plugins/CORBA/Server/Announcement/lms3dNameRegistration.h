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

/// The entry exists as long as this object, which must be destroyed before the ORB. If the naming
/// service cannot be reached, the log says so, and clients need the IOR or the corbaloc.
class lms3dNameRegistration
{
public:
  /// `service` is the URI of a naming context. If empty, the ORB's initial reference NameService is
  /// used. `name` is a stringified name, such as "LMS3D.Scanner" or "robots/LMS3D.Scanner". Its
  /// contexts must exist. Replaces an entry of the same name. Never throws CORBA exceptions.
  lms3dNameRegistration(CORBA::ORB_ptr orb, const std::string& service, const std::string& name,
    CORBA::Object_ptr object);
  /// Removes the entry, unless another server has replaced it. Takes up to half a second for each
  /// of three calls.
  ~lms3dNameRegistration();
  lms3dNameRegistration(const lms3dNameRegistration&) = delete;
  void operator=(const lms3dNameRegistration&) = delete;

private:
  const std::string Name;
  const CORBA::Object_var Object;
  CosNaming::NamingContextExt_var Context;
};

#endif
