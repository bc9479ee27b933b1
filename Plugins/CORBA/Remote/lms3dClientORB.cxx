// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/lms3dClientORB.h"

#include "Common/lms3dCallRetries.h"
#include "Common/lms3dORBLog.h"

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
  int noArguments = 0;
  return CORBA::ORB_init(noArguments, nullptr);
}
} // namespace

CORBA::ORB_ptr lms3dGetClientORB()
{
  static auto* const orb = MakeORB();
  return orb;
}
