// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Announcement/lms3dObjectAddresses.h"

#include <omniORB4/giopEndpoint.h>
#include <omniORB4/omniIOR.h>
#include <omniORB4/omniObjRef.h>

#include <utility>

namespace
{
constexpr const char* TCP = "giop:tcp:";
constexpr const char* TLS = "giop:ssl:";

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

// An object that is served by TLS only has a plain address of port 0.
bool IsUnused(const std::string& address)
{
  const std::string end = ":0";
  return StartsWith(address, TCP) && address.substr(address.size() - end.size()) == end;
}
} // namespace

std::vector<std::string> lms3dGetAddresses(CORBA::Object_ptr object)
{
  omniIOR_var ior = object->_PR_getobj()->_getIOR();
  std::vector<std::string> addresses;
  for (const omni::giopAddress* address : ior->getIORInfo()->addresses())
  {
    const std::string name = address->address();
    if (!IsUnused(name))
    {
      addresses.push_back(name);
    }
  }
  return addresses;
}

bool lms3dIsNetworkAddress(const std::string& address)
{
  return StartsWith(address, TCP) || StartsWith(address, TLS);
}

// Without a version a corbaloc means GIOP 1.0, which does not negotiate character sets.
std::string lms3dGetCorbaloc(const std::vector<std::string>& addresses, const std::string& key)
{
  constexpr std::pair<const char*, const char*> Schemes[] = {
    { TCP, "corbaloc:iiop:1.2@" },
    { TLS, "corbaloc:ssliop:1.2@" },
  };
  for (const std::string& address : addresses)
  {
    for (const auto& scheme : Schemes)
    {
      const std::string start = scheme.first;
      if (StartsWith(address, start))
      {
        return scheme.second + address.substr(start.size()) + "/" + key;
      }
    }
  }
  return {};
}
