// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Announcement/lms3dNameRegistration.h"

#include "Common/lms3dLog.h"

namespace
{
// For each call.
constexpr CORBA::ULong StartMilliseconds = 2000;
constexpr CORBA::ULong EndMilliseconds = 500;

CosNaming::NamingContextExt_ptr FindContext(CORBA::ORB_ptr orb, const std::string& service)
{
  const CORBA::Object_var object = service.empty() ? orb->resolve_initial_references("NameService")
                                                   : orb->string_to_object(service.c_str());
  if (CORBA::is_nil(object))
  {
    return CosNaming::NamingContextExt::_nil();
  }
  omniORB::setClientCallTimeout(object, StartMilliseconds);
  CosNaming::NamingContextExt_var context = CosNaming::NamingContextExt::_narrow(object);
  if (!CORBA::is_nil(context))
  {
    omniORB::setClientCallTimeout(context, StartMilliseconds);
  }
  return context._retn();
}
} // namespace

lms3dNameRegistration::lms3dNameRegistration(
  CORBA::ORB_ptr orb, const std::string& service, const std::string& name, CORBA::Object_ptr object)
  : Name(name)
  , Object(CORBA::Object::_duplicate(object))
{
  try
  {
    this->Context = FindContext(orb, service);
    if (CORBA::is_nil(this->Context))
    {
      lms3dLog("not registered: --naming-service does not name a naming context");
      return;
    }
    const CosNaming::Name_var path = this->Context->to_name(name.c_str());
    this->Context->rebind(path, object);
    lms3dLog("registered with the naming service as " + name);
  }
  catch (const CORBA::Exception& problem)
  {
    this->Context = CosNaming::NamingContextExt::_nil();
    lms3dLog(std::string("not registered with the naming service: ") + problem._name());
  }
}

lms3dNameRegistration::~lms3dNameRegistration()
{
  if (CORBA::is_nil(this->Context))
  {
    return;
  }
  // The end of the server waits for three calls.
  omniORB::setClientCallTimeout(this->Context, EndMilliseconds);
  try
  {
    const CosNaming::Name_var path = this->Context->to_name(this->Name.c_str());
    // Another server may have registered the name since.
    const CORBA::Object_var now = this->Context->resolve(path);
    if (now->_is_equivalent(this->Object))
    {
      this->Context->unbind(path);
    }
  }
  catch (const CORBA::Exception& problem)
  {
    lms3dLog(std::string("the name stays in the naming service: ") + problem._name());
  }
  catch (const omniORB::fatalException& problem)
  {
    lms3dLog(std::string("the name stays in the naming service: ") + problem.errmsg());
  }
}
