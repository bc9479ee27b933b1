// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The memory that the process holds, in bytes (Linux).
 */
#ifndef Memory_h
#define Memory_h

#include <malloc.h>

#include <fstream>
#include <string>

/// A line of /proc/self/status, VmRSS or VmHWM, or of another such file.
inline double GetMemory(const std::string& name, const std::string& fileName = "/proc/self/status")
{
  std::ifstream file(fileName);
  for (std::string word; file >> word;)
  {
    if (word == name + ":")
    {
      double kilobytes = 0.0;
      file >> kilobytes;
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

/// What other work may take.
inline double GetAvailableMemory()
{
  return GetMemory("MemAvailable", "/proc/meminfo");
}

/// What has been taken since it was made; freed memory is first given back to the system.
class MemoryMeter
{
public:
  MemoryMeter()
  {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // lets the peak start anew
    this->Start = GetMemory("VmRSS");
  }

  double GetGrowth() const
  {
    malloc_trim(0);
    return GetMemory("VmRSS") - this->Start;
  }

  double GetPeak() const { return GetMemory("VmHWM") - this->Start; }

private:
  double Start;
};

#endif
