// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dExceptionText.h"

namespace
{
// Explains the most frequent exceptions.
const char* GetMeaning(const CORBA::SystemException& problem)
{
  if (CORBA::TIMEOUT::_downcast(&problem))
  {
    return ": the server does not answer in time";
  }
  if (CORBA::TRANSIENT::_downcast(&problem) || CORBA::COMM_FAILURE::_downcast(&problem))
  {
    return ": no server answers there";
  }
  if (CORBA::BAD_OPERATION::_downcast(&problem))
  {
    return ": the server is older than this operation";
  }
  return "";
}
} // namespace

std::string lms3dDescribe(const CORBA::Exception& problem)
{
  std::string text = problem._name();
  if (const auto* system = CORBA::SystemException::_downcast(&problem))
  {
    // Null for codes that omniORB does not define.
    const char* const detail = system->NP_minorString();
    text.append(detail ? std::string(", ") + detail : "").append(GetMeaning(*system));
  }
  else if (const auto* argument = LMS3D::InvalidArgument::_downcast(&problem))
  {
    text.append(": ").append(argument->reason);
  }
  else if (const auto* scene = LMS3D::SceneFailed::_downcast(&problem))
  {
    text.append(": ").append(scene->reason);
  }
  else if (const auto* permission = LMS3D::NotPermitted::_downcast(&problem))
  {
    text.append(": ").append(permission->reason);
  }
  else if (const auto* limit = LMS3D::LimitExceeded::_downcast(&problem))
  {
    text.append(": ").append(limit->reason);
  }
  else if (const auto* map = LMS3D::NoFusedMap::_downcast(&problem))
  {
    text.append(": ").append(map->reason);
  }
  return text;
}
