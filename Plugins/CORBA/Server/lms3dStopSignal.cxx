// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStopSignal.h"

#include <cstring>

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

lms3dStopSignal::lms3dStopSignal()
{
  sigemptyset(&this->Signals);
  sigaddset(&this->Signals, SIGINT);
  sigaddset(&this->Signals, SIGTERM);
  if (!IsIgnored(SIGHUP))
  {
    sigaddset(&this->Signals, SIGHUP);
  }
  pthread_sigmask(SIG_BLOCK, &this->Signals, nullptr);
}

// Only Wait() removes a signal, so it is pending until then.
bool lms3dStopSignal::IsPending() const
{
  sigset_t pending;
  sigpending(&pending);
  sigandset(&pending, &pending, &this->Signals);
  return sigisemptyset(&pending) == 0;
}

std::string lms3dStopSignal::Wait() const
{
  int signal = 0;
  sigwait(&this->Signals, &signal);
  return std::string("SIG") + sigabbrev_np(signal);
}
