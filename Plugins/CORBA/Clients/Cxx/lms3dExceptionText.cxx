// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dExceptionText.h"

std::string lms3dDescribe(const CORBA::Exception& problem)
{
  std::string text = problem._name();
  if (const auto* system = CORBA::SystemException::_downcast(&problem))
  {
    text.append(", ").append(system->NP_minorString());
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
  return text;
}
