// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRequestGate.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/omniInterceptors.h>

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

CORBA::Boolean Pass(Interceptors::serverReceiveRequest_T::info_T&)
{
  const std::lock_guard<std::mutex> lock(Gate.Mutex);
  if (!Gate.IsOpen)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
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
