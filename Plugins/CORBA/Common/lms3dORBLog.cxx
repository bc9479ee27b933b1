// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dORBLog.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/linkHacks.h>

#include <algorithm>
#include <chrono>
#include <mutex>

// Nothing else refers to the transport, which the linker would drop.
OMNI_FORCE_LINK(omnisslTP);

namespace
{
// The ORB takes a plain function, so these are the process's.
void (*Log)(const std::string&) = nullptr;
bool IsTLSWanted = false;

// The ORB has a line for each broken message: who sends many must not fill the disk.
constexpr int MostLinesASecond = 20;

// Which line of its second one is that is written now, counted from 1.
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
  if (number <= MostLinesASecond)
  {
    Log(line);
  }
  else if (number == MostLinesASecond + 1)
  {
    Log("omniORB: the rest of this second's lines are left out");
  }
}

void LogLine(const char* text)
{
  std::string line(text);
  line.erase(line.find_last_not_of('\n') + 1);
  // Who raises the level looks for something, and wants all of it.
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
