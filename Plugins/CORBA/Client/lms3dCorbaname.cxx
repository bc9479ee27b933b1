// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dCorbaname.h"

#include <omniORB4/Naming.hh>
#include <omniORB4/omniURI.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace
{
const std::string Scheme = "corbaname:";

bool IsHexadecimal(char character)
{
  return std::isxdigit(static_cast<unsigned char>(character)) != 0;
}

// "%20" is a space, as in all URLs.
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
} // namespace

bool lms3dIsCorbaname(const std::string& url)
{
  return url.rfind(Scheme, 0) == 0;
}

// The service is written as in a corbaloc, the name behind '#'.
CORBA::Object_ptr lms3dFindByName(
  CORBA::ORB_ptr orb, const std::string& corbaname, CORBA::ULong timeout)
{
  const std::size_t end = std::min(corbaname.find('#'), corbaname.size());
  std::string service = "corbaloc:" + corbaname.substr(Scheme.size(), end - Scheme.size());
  service.append(service.find('/') == std::string::npos ? "/NameService" : "");
  const CORBA::Object_var object = orb->string_to_object(service.c_str());
  const CosNaming::NamingContext_var context = CosNaming::NamingContext::_unchecked_narrow(object);
  if (timeout != 0)
  {
    omniORB::setClientCallTimeout(context, timeout);
  }
  return Resolve(context, Unescape(corbaname.substr(std::min(end + 1, corbaname.size()))));
}
