// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/lms3dClientORB.h"

#include "Common/lms3dCallRetries.h"
#include "Common/lms3dORBLog.h"
#include "Common/lms3dORBSources.h"

#include <iostream>

namespace
{
void PrintLine(const std::string& line)
{
  std::cerr << line << '\n';
}

CORBA::ORB_ptr MakeORB()
{
  lms3dSetORBLog(PrintLine, {});
  lms3dLimitRetries();
  constexpr const char* rule = "clientTransportRule";
  const char* options[][2] = { { lms3dORBSources({}).IsSet(rule) ? nullptr : rule,
                                 lms3dClientTransportRule },
    { nullptr, nullptr } };
  int noArguments = 0;
  return CORBA::ORB_init(noArguments, nullptr, "omniORB4", options);
}
} // namespace

CORBA::ORB_ptr lms3dGetClientORB()
{
  static auto* const orb = MakeORB();
  return orb;
}
