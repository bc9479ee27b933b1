// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Starts threads that receive no signals.
 */
#ifndef lms3dThreadWithoutSignals_h
#define lms3dThreadWithoutSignals_h

#include <thread>
#include <utility>

#include <csignal>

/// Starts a thread that blocks all signals, so that other threads of the process receive them.
template <typename Function>
std::thread lms3dStartThreadWithoutSignals(Function function)
{
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(function));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

#endif
