// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dLog.h"

#include "Common/lms3dLineWriter.h"
#include "Common/lms3dLogLimit.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <ctime>

#include <unistd.h>

namespace
{
constexpr std::size_t MaximumLength = 1000;
constexpr std::chrono::milliseconds LogFlushTime(200);
constexpr std::chrono::milliseconds FinishTime(500);

std::string GetTime()
{
  using namespace std::chrono;
  const auto now = system_clock::now();
  const std::time_t seconds = system_clock::to_time_t(now);
  const auto fraction = duration_cast<milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm parts = {};
  gmtime_r(&seconds, &parts);
  char day[32];
  std::strftime(day, sizeof(day), "%Y-%m-%dT%H:%M:%S", &parts);
  char time[48];
  std::snprintf(time, sizeof(time), "%s.%03dZ", day, static_cast<int>(fraction));
  return time;
}

std::string DescribeLeftOut(std::size_t count)
{
  return GetTime() + ' ' + std::to_string(count) +
    " lines are left out here, because the log was not read";
}

std::string Escape(char character)
{
  if (character >= ' ' && character <= '~')
  {
    return { character };
  }
  if (character == '\n')
  {
    return "\\n";
  }
  char code[8];
  std::snprintf(code, sizeof(code), "\\x%02x", static_cast<unsigned char>(character));
  return code;
}

// These objects are never destroyed, because other threads may log until the process ends.
lms3dLineWriter& GetLog()
{
  static auto* const log = new lms3dLineWriter(STDERR_FILENO, DescribeLeftOut);
  return *log;
}

lms3dLineWriter& GetOutput()
{
  static auto* const output = new lms3dLineWriter(STDOUT_FILENO, DescribeLeftOut);
  return *output;
}

lms3dLogLimit& GetLimit(lms3dLogKind kind)
{
  // In the order of lms3dLogKind.
  static auto* const limits = new lms3dLogLimit[]{ { "listeners", lms3dLog }, { "scans", lms3dLog },
    { "scenes", lms3dLog }, { "VTK", lms3dLog } };
  return limits[static_cast<std::size_t>(kind)];
}
} // namespace

void lms3dLog(const std::string& text)
{
  GetLog().Write(GetTime() + ' ' + lms3dMakePrintable(text));
}

void lms3dLog(lms3dLogKind kind, const std::string& text)
{
  GetLimit(kind).Write(text);
}

void lms3dPrint(const std::string& lines)
{
  GetLog().Flush(LogFlushTime);
  GetOutput().Write(lines);
}

void lms3dFinishLog()
{
  for (const lms3dLogKind kind :
    { lms3dLogKind::Listeners, lms3dLogKind::Scans, lms3dLogKind::Scenes, lms3dLogKind::VTK })
  {
    GetLimit(kind).Report();
  }
  GetLog().Flush(FinishTime);
  GetOutput().Flush(FinishTime);
}

std::string lms3dMakePrintable(const std::string& text)
{
  std::string printable;
  for (const char character : text)
  {
    if (printable.size() >= MaximumLength)
    {
      return printable + "...";
    }
    printable += Escape(character);
  }
  return printable;
}
