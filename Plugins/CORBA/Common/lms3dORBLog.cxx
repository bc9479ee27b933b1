// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dORBLog.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/linkHacks.h>

#include <algorithm>
#include <chrono>
#include <mutex>

// Without a reference the linker would drop the transport.
OMNI_FORCE_LINK(omnisslTP);

namespace
{
// Global, because the ORB accepts only a plain function.
void (*Log)(const std::string&) = nullptr;
bool IsTLSWanted = false;

// The ORB logs each broken message. A client that sends many must not fill the disk.
constexpr int MaximumLinesPerSecond = 20;

// Counts a line, and returns the number of lines of the current second.
int CountLine()
{
  using Clock = std::chrono::steady_clock;
  static std::mutex mutex;
  static Clock::time_point begin;
  static int lines = 0;

  const std::lock_guard<std::mutex> lock(mutex);
  const Clock::time_point now = Clock::now();
  if (now - begin > std::chrono::seconds(1))
  {
    begin = now;
    lines = 0;
  }
  return ++lines;
}

bool IsWanted(const std::string& line)
{
  return IsTLSWanted || line.find("SSL transport disabled") == std::string::npos;
}

void LogLimited(const std::string& line)
{
  const int number = CountLine();
  if (number <= MaximumLinesPerSecond)
  {
    Log(line);
  }
  else if (number == MaximumLinesPerSecond + 1)
  {
    Log("omniORB: more lines in this second; these lines are left out");
  }
}

void LogLine(const char* text)
{
  std::string line(text);
  line.erase(line.find_last_not_of('\n') + 1);
  // An administrator who raises the level needs all lines.
  if (omniORB::traceLevel > 1)
  {
    Log(line);
  }
  else if (IsWanted(line))
  {
    LogLimited(line);
  }
}
} // namespace

void lms3dSetORBLog(void (*log)(const std::string& line), const std::vector<std::string>& settings)
{
  Log = log;
  IsTLSWanted = std::any_of(settings.begin(), settings.end(),
    [](const std::string& setting) { return setting.find("ssl") != std::string::npos; });
  omniORB::setLogFunction(LogLine);
}
