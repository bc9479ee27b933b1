// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dExitLimit.h"

#include "Common/lms3dLog.h"
#include "Common/lms3dORBLog.h"
#include "Common/lms3dThreadWithoutSignals.h"

#include <chrono>
#include <cstdlib>

namespace
{
// lms3dFinishLog() adds a second at most.
constexpr std::chrono::seconds MaximumEnd(4);
} // namespace

// lms3dStopSignal, which blocks the signals in later threads, is created after this object.
lms3dExitLimit::lms3dExitLimit()
  : Thread(lms3dStartThreadWithoutSignals([this] { this->Run(); }))
{
}

lms3dExitLimit::~lms3dExitLimit()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Ended = true;
  }
  this->Changed.notify_all();
  this->Thread.join();
}

void lms3dExitLimit::Begin(int exitCode)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Begun)
    {
      return;
    }
    this->Begun = true;
    this->ExitCode = exitCode;
  }
  this->Changed.notify_all();
}

void lms3dExitLimit::Run()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return this->Begun || this->Ended; });
  if (!this->Changed.wait_for(lock, MaximumEnd, [this] { return this->Ended; }))
  {
    lms3dLog("ended; clients, listeners or the naming service did not answer in time");
    lms3dFinishORBLog();
    lms3dFinishLog();
    std::_Exit(this->ExitCode);
  }
}
