// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dExitLimit.h"

#include "Common/lms3dLog.h"

#include <chrono>
#include <cstdlib>

namespace
{
// As long as a client may take to read an answer; see lms3dGetORBSettings().
constexpr std::chrono::seconds MaximumEnd(5);
} // namespace

lms3dExitLimit::~lms3dExitLimit()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Ended = true;
  }
  this->Changed.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void lms3dExitLimit::Begin(int exitCode)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Thread.joinable())
  {
    this->Thread = std::thread([this, exitCode] { this->Run(exitCode); });
  }
}

void lms3dExitLimit::Run(int exitCode)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  if (!this->Changed.wait_for(lock, MaximumEnd, [this] { return this->Ended; }))
  {
    lms3dLog("ended; clients, listeners or the naming service did not answer in time");
    lms3dFinishLog();
    std::_Exit(exitCode);
  }
}
