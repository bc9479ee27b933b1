// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientORB.h"

CORBA::ORB_ptr lms3dGetClientORB()
{
  static const CORBA::ORB_ptr orb = []
  {
    int noArguments = 0;
    return CORBA::ORB_init(noArguments, nullptr, "omniORB4");
  }();
  return orb;
}

void lms3dSetCallTimeout(std::chrono::milliseconds timeout)
{
  lms3dGetClientORB(); // which its settings need
  omniORB::setClientThreadCallTimeout(static_cast<CORBA::ULong>(timeout.count()));
}
