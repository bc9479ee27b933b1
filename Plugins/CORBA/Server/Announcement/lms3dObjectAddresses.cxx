// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Announcement/lms3dObjectAddresses.h"

#include <omniORB4/giopEndpoint.h>
#include <omniORB4/omniIOR.h>
#include <omniORB4/omniObjRef.h>

#include <utility>

std::vector<std::string> lms3dGetAddresses(CORBA::Object_ptr object)
{
  omniIOR_var ior = object->_PR_getobj()->_getIOR();
  std::vector<std::string> addresses;
  for (const omni::giopAddress* address : ior->getIORInfo()->addresses())
  {
    // An object that is served by TLS only has an unused plain address of port 0.
    const std::string name = address->address();
    const std::string unused = ":0";
    if (name.size() < unused.size() || name.substr(name.size() - unused.size()) != unused)
    {
      addresses.push_back(name);
    }
  }
  return addresses;
}

// Without a version a corbaloc means GIOP 1.0, which does not negotiate character sets.
std::string lms3dGetCorbaloc(const std::vector<std::string>& addresses, const std::string& key)
{
  constexpr std::pair<const char*, const char*> Schemes[] = {
    { "giop:tcp:", "corbaloc:iiop:1.2@" },
    { "giop:ssl:", "corbaloc:ssliop:1.2@" },
  };
  for (const std::string& address : addresses)
  {
    for (const auto& scheme : Schemes)
    {
      const std::string start = scheme.first;
      if (address.rfind(start, 0) == 0)
      {
        return scheme.second + address.substr(start.size()) + "/" + key;
      }
    }
  }
  return {};
}
