// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dORBLog.h"

#include "Common/lms3dLog.h"
#include "Common/lms3dLogLimit.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/linkHacks.h>

#include <algorithm>
#include <atomic>
#include <sstream>

// Without a reference the linker would drop the transport.
OMNI_FORCE_LINK(omnisslTP);

namespace
{
// Global, because the ORB accepts only a plain function. The limit is never destroyed, because the
// ORB may log until the process ends.
void (*Log)(const std::string&) = nullptr;
std::atomic<lms3dLogLimit*> Limit = nullptr;
bool IsTLSWanted = false;

bool IsWanted(const std::string& line)
{
  return IsTLSWanted || line.find("SSL transport disabled") == std::string::npos;
}

// At higher levels the ORB writes texts of several lines. The prefix distinguishes them from
// others.
void LogLines(const std::string& text)
{
  std::istringstream lines(text);
  std::string line;
  for (const char* prefix = ""; std::getline(lines, line); prefix = "omniORB: ")
  {
    Log(prefix + lms3dMakePrintable(line));
  }
}

void LogText(const char* text)
{
  std::string line(text);
  line.erase(line.find_last_not_of('\n') + 1);
  // An administrator who raises the level needs all lines.
  if (omniORB::traceLevel > 1)
  {
    LogLines(line);
  }
  else if (IsWanted(line))
  {
    Limit.load()->Write(lms3dMakePrintable(line));
  }
}
} // namespace

void lms3dSetORBLog(void (*log)(const std::string& line), const std::vector<std::string>& settings)
{
  Log = log;
  Limit = new lms3dLogLimit("omniORB", log);
  IsTLSWanted = std::any_of(settings.begin(), settings.end(),
    [](const std::string& setting) { return setting.find("ssl") != std::string::npos; });
  omniORB::setLogFunction(LogText);
}

void lms3dFinishORBLog()
{
  if (lms3dLogLimit* const limit = Limit)
  {
    limit->Report();
  }
}
