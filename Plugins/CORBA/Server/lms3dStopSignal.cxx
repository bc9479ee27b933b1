// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStopSignal.h"

lms3dStopSignal::lms3dStopSignal()
{
  sigemptyset(&this->Signals);
  sigaddset(&this->Signals, SIGINT);
  sigaddset(&this->Signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &this->Signals, nullptr);
}

// Nobody but Wait() takes the signals, so until then they are pending.
bool lms3dStopSignal::HasCome() const
{
  sigset_t pending;
  sigpending(&pending);
  return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

std::string lms3dStopSignal::Wait() const
{
  int signal = 0;
  sigwait(&this->Signals, &signal);
  return signal == SIGINT ? "SIGINT" : "SIGTERM";
}
