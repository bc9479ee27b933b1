// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Clients that take all room for clients that wait.
 */
#ifndef CrowdOfWaiters_h
#define CrowdOfWaiters_h

#include "LMS3DScanner.hh"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

/// Waits for a scan that never comes, as often at once as a server lets anybody, until its end.
class CrowdOfWaiters
{
public:
  /// A test failure where the server refuses nobody.
  explicit CrowdOfWaiters(const std::string& reference);
  ~CrowdOfWaiters();
  CrowdOfWaiters(const CrowdOfWaiters&) = delete;
  void operator=(const CrowdOfWaiters&) = delete;

private:
  void Wait();

  const LMS3D::LaserScanner_var Scanner;
  std::atomic<bool> IsOver{ false };
  std::atomic<int> Refused{ 0 };
  std::vector<std::thread> Clients;
};

#endif
