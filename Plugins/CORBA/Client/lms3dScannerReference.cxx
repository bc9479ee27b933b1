// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dScannerReference.h"

#include <fstream>
#include <stdexcept>

LMS3D::LaserScanner_ptr lms3dFindScanner(CORBA::ORB_ptr orb, const std::string& reference)
{
  std::string text = reference;
  std::ifstream file(reference);
  if (file)
  {
    std::getline(file, text);
  }
  const CORBA::Object_var object = orb->string_to_object(text.c_str());
  LMS3D::LaserScanner_ptr scanner = LMS3D::LaserScanner::_narrow(object);
  if (CORBA::is_nil(scanner))
  {
    throw std::runtime_error("what is at \"" + reference + "\" is no scanner of LMS3D");
  }
  return scanner;
}
