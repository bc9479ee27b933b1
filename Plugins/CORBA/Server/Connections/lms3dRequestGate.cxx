// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dRequestGate.h"

#include "Connections/lms3dMessageFilter.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/omniInterceptors.h>
#include <omniORB4/omniTransport.h>

// In this order, because they do not include each other.
#include <omniORB4/internal/giopStrand.h>
#include <omniORB4/internal/giopStream.h>

#include <omniORB4/internal/GIOP_S.h>

#include <condition_variable>
#include <mutex>

namespace
{
using Interceptors = omni::omniInterceptors;

// Global, because the ORB accepts only plain functions.
struct
{
  std::mutex Mutex;
  std::condition_variable Changed;
  bool IsStarting = true;
  bool IsOpen = false;
} Gate;

// The ORB unmarshals and answers a call in one thread, and keeps the connection meanwhile.
thread_local const omni::giopStrand* Connection = nullptr;

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

// The longest arguments are references of listeners.
constexpr CORBA::ULong MaximumArgumentBytes = 65536;

// Runs before the ORB allocates memory for the arguments, which it never frees if the rest of the
// message does not come.
void RequireSmall(omni::GIOP_S& request)
{
  if (lms3dMessageFilter::IsRequestIncomplete() ||
    request.checkInputOverrun(1, MaximumArgumentBytes))
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
  Connection = &request.giop_s.strand();
  return true;
}
} // namespace

void lms3dRequestGate::Install()
{
  lms3dMessageFilter::Install();
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

const omni::giopStrand* lms3dRequestGate::GetConnection()
{
  return Connection;
}

bool lms3dRequestGate::IsClientConnected()
{
  if (!Connection)
  {
    return true;
  }
  const omni_tracedmutex_lock lock(*omni::omniTransportLock);
  return Connection->state() != omni::giopStrand::DYING;
}
