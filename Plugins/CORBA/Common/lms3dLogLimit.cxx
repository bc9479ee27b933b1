// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dLogLimit.h"

#include <utility>

lms3dLogLimit::lms3dLogLimit(std::string kind, Log log)
  : Kind(std::move(kind))
  , LogLine(log)
{
}

void lms3dLogLimit::Write(const std::string& line)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto now = std::chrono::steady_clock::now();
  if (now - this->Begin >= std::chrono::seconds(1))
  {
    this->ReportLocked();
    this->Begin = now;
    this->LinesOfSecond = 0;
  }
  if (++this->LinesOfSecond <= MaximumPerSecond)
  {
    this->LogLine(line);
  }
  else if (++this->LeftOut == 1)
  {
    this->LogLine(this->Kind + ": more lines in this second; these lines are left out");
  }
}

void lms3dLogLimit::Report()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->ReportLocked();
}

void lms3dLogLimit::ReportLocked()
{
  const std::size_t count = std::exchange(this->LeftOut, 0);
  if (count != 0)
  {
    this->LogLine(this->Kind + ": " + std::to_string(count) + " lines were left out");
  }
}
