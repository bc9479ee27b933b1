// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStopSignal.h"

#include <cstring>

namespace
{
// As nohup has it. Linux would keep it for Wait() all the same.
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

// Nobody but Wait() takes the signals, so until then they are pending.
bool lms3dStopSignal::HasCome() const
{
  sigset_t come;
  sigpending(&come);
  sigandset(&come, &come, &this->Signals);
  return sigisemptyset(&come) == 0;
}

std::string lms3dStopSignal::Wait() const
{
  int signal = 0;
  sigwait(&this->Signals, &signal);
  return std::string("SIG") + sigabbrev_np(signal);
}
