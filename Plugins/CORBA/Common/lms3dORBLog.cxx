// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dORBLog.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/linkHacks.h>

#include <algorithm>

// Nothing else refers to the transport, which the linker would drop.
OMNI_FORCE_LINK(omnisslTP);

namespace
{
// The ORB takes a plain function, so these are the process's.
void (*Log)(const std::string&) = nullptr;
bool IsTLSWanted = false;

void LogLine(const char* text)
{
  std::string line(text);
  line.erase(line.find_last_not_of('\n') + 1);
  if (IsTLSWanted || line.find("SSL transport disabled") == std::string::npos)
  {
    Log(line);
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
