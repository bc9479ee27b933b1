// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStopSignal.h"

#include <cstring>
#include <utility>

namespace
{
// Under nohup. Linux would keep a blocked signal for Wait() although it is ignored.
bool IsIgnored(int signal)
{
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}
} // namespace

lms3dStopSignal::lms3dStopSignal(std::function<void()> onArrival)
  : OnArrival(std::move(onArrival))
{
  sigemptyset(&this->Signals);
  sigaddset(&this->Signals, SIGINT);
  sigaddset(&this->Signals, SIGTERM);
  if (!IsIgnored(SIGHUP))
  {
    sigaddset(&this->Signals, SIGHUP);
  }
  pthread_sigmask(SIG_BLOCK, &this->Signals, nullptr);
  this->Thread = std::thread([this] { this->Run(); });
}

lms3dStopSignal::~lms3dStopSignal()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Ended = true;
  }
  // Wakes the thread if no signal has arrived.
  pthread_kill(this->Thread.native_handle(), SIGINT);
  this->Thread.join();
}

bool lms3dStopSignal::IsPending() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return !this->Name.empty();
}

std::string lms3dStopSignal::Wait() const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return !this->Name.empty(); });
  return this->Name;
}

void lms3dStopSignal::Run()
{
  int signal = 0;
  sigwait(&this->Signals, &signal);
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Ended)
    {
      return;
    }
    this->Name = std::string("SIG") + sigabbrev_np(signal);
  }
  this->OnArrival();
  this->Changed.notify_all();
}
