// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dLog.h"

#include <chrono>
#include <cstdio>
#include <ctime>

void lms3dLog(const std::string& text)
{
  using namespace std::chrono;
  const auto now = system_clock::now();
  const std::time_t seconds = system_clock::to_time_t(now);
  const auto fraction = duration_cast<milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm parts = {};
  gmtime_r(&seconds, &parts);
  char day[32];
  std::strftime(day, sizeof(day), "%Y-%m-%dT%H:%M:%S", &parts);
  // One call, so that the lines of several threads do not mix.
  std::fprintf(stderr, "%s.%03dZ %s\n", day, static_cast<int>(fraction), text.c_str());
}
