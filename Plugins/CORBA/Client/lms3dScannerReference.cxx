// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dScannerReference.h"

#include <omniORB4/Naming.hh>
#include <omniORB4/omniURI.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <stdexcept>

namespace
{
// The ORB resolves these itself.
bool IsURL(const std::string& text)
{
  constexpr std::array<const char*, 3> schemes = { "IOR:", "corbaloc:", "corbaname:" };
  return std::any_of(schemes.begin(), schemes.end(),
    [&text](const char* scheme) { return text.rfind(scheme, 0) == 0; });
}

// The beginning of a long text is enough for the user to recognize it.
std::string Quote(const std::string& text)
{
  constexpr std::size_t MaximumLength = 200;
  return '"' + text.substr(0, MaximumLength) + (text.size() > MaximumLength ? "...\"" : "\"");
}

// The path of "file:PATH", "file://PATH" or "PATH".
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
  // Reads one word, up to the maximum length of a reference, from a file of any content.
  constexpr int MaximumLength = 65536;
  file.width(MaximumLength);
  file >> text;
  if (!IsURL(text))
  {
    throw std::runtime_error(Quote(name) +
      " is neither a corbaloc, corbaname or IOR, nor a file with one, which the server writes with "
      "--ior");
  }
  return text;
}

const std::string CorbanameScheme = "corbaname:";

bool IsHexadecimal(char character)
{
  return std::isxdigit(static_cast<unsigned char>(character)) != 0;
}

// "%20" is a space, as in all URLs. Throws CORBA::BAD_PARAM for other uses of "%".
std::string Unescape(const std::string& text)
{
  constexpr int Base = 16;
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    plain.push_back(text[i]);
    if (text[i] == '%')
    {
      const std::string digits = text.substr(i + 1, 2);
      if (digits.size() < 2 || !std::all_of(digits.begin(), digits.end(), IsHexadecimal))
      {
        throw CORBA::BAD_PARAM();
      }
      plain.back() = static_cast<char>(std::stoi(digits, nullptr, Base));
      i += digits.size();
    }
  }
  return plain;
}

CORBA::Object_ptr Resolve(CosNaming::NamingContext_ptr context, const std::string& name)
{
  try
  {
    const CosNaming::Name_var path = omni::omniURI::stringToName(name.c_str());
    return context->resolve(path);
  }
  catch (const CORBA::UserException&)
  {
    throw CORBA::BAD_PARAM();
  }
}

// The ORB can resolve a corbaname too, but without a limit of the naming service's time. The
// service is written as in a corbaloc, followed by '#' and the name.
CORBA::Object_ptr FindByName(CORBA::ORB_ptr orb, const std::string& corbaname, CORBA::ULong timeout)
{
  const std::size_t end = std::min(corbaname.find('#'), corbaname.size());
  std::string service =
    "corbaloc:" + corbaname.substr(CorbanameScheme.size(), end - CorbanameScheme.size());
  service.append(service.find('/') == std::string::npos ? "/NameService" : "");
  const CORBA::Object_var object = orb->string_to_object(service.c_str());
  const CosNaming::NamingContext_var context = CosNaming::NamingContext::_unchecked_narrow(object);
  if (timeout != 0)
  {
    omniORB::setClientCallTimeout(context, timeout);
  }
  return Resolve(context, Unescape(corbaname.substr(std::min(end + 1, corbaname.size()))));
}

CORBA::Object_ptr FindObject(CORBA::ORB_ptr orb, const std::string& url, CORBA::ULong timeout)
{
  try
  {
    return url.rfind(CorbanameScheme, 0) == 0 ? FindByName(orb, url, timeout)
                                              : orb->string_to_object(url.c_str());
  }
  catch (const CORBA::BAD_PARAM&)
  {
    throw std::runtime_error(Quote(url) + " names no object. The server prints a valid reference");
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
    throw std::runtime_error("the object at " + Quote(reference) + " is not a scanner of LMS3D");
  }
  LimitCalls(scanner, timeout);
  return scanner;
}
