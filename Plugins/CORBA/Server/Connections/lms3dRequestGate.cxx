// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRequestGate.h"

#include "lms3dCaller.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/omniInterceptors.h>
#include <omniORB4/omniTransport.h>

// In this order, since they do not include each other.
#include <omniORB4/internal/giopStrand.h>
#include <omniORB4/internal/giopStream.h>

#include <omniORB4/internal/GIOP_S.h>

#include <condition_variable>
#include <mutex>

namespace
{
using Interceptors = omni::omniInterceptors;

/// The ORB takes plain functions, so this is the process's.
struct
{
  std::mutex Mutex;
  std::condition_variable Changed;
  bool IsStarting = true;
  bool IsOpen = false;
} Gate;

void Set(bool isOpen)
{
  {
    const std::lock_guard<std::mutex> lock(Gate.Mutex);
    Gate.IsStarting = false;
    Gate.IsOpen = isOpen;
  }
  Gate.Changed.notify_all();
}

void RunAfterStart(Interceptors::createThread_T::info_T& thread)
{
  {
    std::unique_lock<std::mutex> lock(Gate.Mutex);
    Gate.Changed.wait(lock, [] { return !Gate.IsStarting; });
  }
  thread.run();
}

// The longest are those with the reference of a listener.
constexpr CORBA::ULong MostArgumentBytes = 65536;

// Before the ORB makes room for arguments of any length, which it never gives back where the rest of
// the message does not come. Of a message in fragments, whose size only its end tells, it takes
// everything to be possible.
void RequireSmall(omni::GIOP_S& request)
{
  if (request.checkInputOverrun(1, MostArgumentBytes))
  {
    throw CORBA::IMP_LIMIT(0, CORBA::COMPLETED_NO);
  }
}

void RequireOpen()
{
  const std::lock_guard<std::mutex> lock(Gate.Mutex);
  if (!Gate.IsOpen)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
}

CORBA::Boolean Pass(Interceptors::serverReceiveRequest_T::info_T& request)
{
  RequireSmall(request.giop_s);
  RequireOpen();
  lms3dSetCaller(request.giop_s.strand());
  return true;
}
} // namespace

void lms3dRequestGate::Install()
{
  Interceptors* const interceptors = omniORB::getInterceptors();
  interceptors->createThread.add(RunAfterStart);
  interceptors->serverReceiveRequest.add(Pass);
}

void lms3dRequestGate::Open()
{
  Set(true);
}

void lms3dRequestGate::Close()
{
  Set(false);
}
