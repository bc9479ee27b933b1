// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dCallRetries.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/minorCode.h>

namespace
{
// The ORB then uses the first address again.
CORBA::Boolean RetryOnce(void*, CORBA::ULong retries, const CORBA::TRANSIENT& problem)
{
  return retries == 0 && problem.minor() == omni::TRANSIENT_FailedOnForwarded;
}
} // namespace

void lms3dLimitRetries()
{
  omniORB::installTransientExceptionHandler(nullptr, RetryOnce);
}
