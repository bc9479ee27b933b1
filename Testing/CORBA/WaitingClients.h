// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Clients that occupy all places for waiting calls.
 */
#ifndef WaitingClients_h
#define WaitingClients_h

#include "LMS3DScanner.hh"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

/// Waits for a scan that never comes, with as many calls as the server permits, until its
/// destruction.
class WaitingClients
{
public:
  /// Fails the test if the server refuses no call.
  explicit WaitingClients(const std::string& reference);
  ~WaitingClients();
  WaitingClients(const WaitingClients&) = delete;
  void operator=(const WaitingClients&) = delete;

private:
  void Wait();

  const LMS3D::LaserScanner_var Scanner;
  std::atomic<bool> IsOver{ false };
  std::atomic<int> Refused{ 0 };
  std::vector<std::thread> Clients;
};

#endif
