// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientORB.h"

namespace
{
// For a naming service, which has no limit of its own.
const char* Options[][2] = { { "clientCallTimeOutPeriod", "5000" }, { nullptr, nullptr } };

CORBA::ORB_ptr MakeORB()
{
  int noArguments = 0;
  return CORBA::ORB_init(noArguments, nullptr, "omniORB4", Options);
}
} // namespace

CORBA::ORB_ptr lms3dGetClientORB()
{
  static const CORBA::ORB_ptr orb = MakeORB();
  return orb;
}
