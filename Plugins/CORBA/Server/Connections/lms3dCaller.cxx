// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dCaller.h"

#include <omniORB4/omniTransport.h>

#include <omniORB4/internal/giopStrand.h>

namespace
{
// The ORB unmarshals and answers a call in one thread, and keeps the connection for as long.
thread_local const omni::giopStrand* Caller = nullptr;
} // namespace

void lms3dSetCaller(const omni::giopStrand& connection)
{
  Caller = &connection;
}

const omni::giopStrand* lms3dGetCaller()
{
  return Caller;
}

bool lms3dIsCallerThere()
{
  // This process itself has no connection.
  if (!Caller)
  {
    return true;
  }
  const omni_tracedmutex_lock lock(*omni::omniTransportLock);
  return Caller->state() != omni::giopStrand::DYING;
}
