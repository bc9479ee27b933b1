// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dScannerReference.h"

#include "lms3dCorbaname.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <stdexcept>

namespace
{
// What the ORB takes itself.
bool IsURL(const std::string& text)
{
  constexpr std::array<const char*, 3> schemes = { "IOR:", "corbaloc:", "corbaname:" };
  return std::any_of(schemes.begin(), schemes.end(),
    [&text](const char* scheme) { return text.rfind(scheme, 0) == 0; });
}

// The beginning of a word is enough to tell the user what it is.
std::string Quote(const std::string& text)
{
  constexpr std::size_t Longest = 200;
  return '"' + text.substr(0, Longest) + (text.size() > Longest ? "...\"" : "\"");
}

// Of a URL "file:PATH" or "file://PATH", or a name without any scheme.
std::string GetFileName(const std::string& text)
{
  const std::string scheme = "file:";
  if (text.rfind(scheme, 0) != 0)
  {
    return text;
  }
  return text.substr(text.rfind(scheme + "//", 0) == 0 ? scheme.size() + 2 : scheme.size());
}

std::string ReadFile(const std::string& name)
{
  std::ifstream file(name);
  std::string text;
  // A word is read, not a line: whatever is in the file, no more than a reference can have.
  constexpr int Longest = 65536;
  file.width(Longest);
  file >> text;
  if (!IsURL(text))
  {
    throw std::runtime_error(Quote(name) +
      " is no corbaloc, corbaname or IOR, and no file with one: a server writes a file with --ior");
  }
  return text;
}

CORBA::Object_ptr FindObject(CORBA::ORB_ptr orb, const std::string& url, CORBA::ULong timeout)
{
  try
  {
    return lms3dIsCorbaname(url) ? lms3dFindByName(orb, url, timeout)
                                 : orb->string_to_object(url.c_str());
  }
  catch (const CORBA::BAD_PARAM&)
  {
    throw std::runtime_error(Quote(url) + " names no object; the server prints one that does");
  }
}

void LimitCalls(CORBA::Object_ptr object, CORBA::ULong timeout)
{
  if (timeout != 0)
  {
    omniORB::setClientCallTimeout(object, timeout);
  }
}
} // namespace

LMS3D::LaserScanner_ptr lms3dFindScanner(
  CORBA::ORB_ptr orb, const std::string& reference, CORBA::ULong timeout)
{
  const std::string url = IsURL(reference) ? reference : ReadFile(GetFileName(reference));
  const CORBA::Object_var object = FindObject(orb, url, timeout);
  LimitCalls(object, timeout);
  LMS3D::LaserScanner_ptr scanner = LMS3D::LaserScanner::_narrow(object);
  if (CORBA::is_nil(scanner))
  {
    throw std::runtime_error("what is at " + Quote(reference) + " is no scanner of LMS3D");
  }
  LimitCalls(scanner, timeout);
  return scanner;
}
