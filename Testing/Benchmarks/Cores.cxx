// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cores.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
std::string ReadFile(const std::string& name)
{
  std::ifstream file(name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The cores that this process may use.
Cores GetAllowedCores()
{
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  Cores cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
  {
    if (CPU_ISSET(core, &set))
    {
      cores.insert(core);
    }
  }
  return cores;
}

Cores GetSiblings(int core)
{
  return ParseCores(ReadFile(
    "/sys/devices/system/cpu/cpu" + std::to_string(core) + "/topology/thread_siblings_list"));
}

std::string Join(const Cores& cores)
{
  std::string text;
  for (int core : cores)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(core);
  }
  return text;
}

double GetSeconds(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The processor's time of this process and of its children that have ended.
double GetOwnSeconds()
{
  double seconds = 0.0;
  for (auto who : { RUSAGE_SELF, RUSAGE_CHILDREN })
  {
    rusage usage;
    getrusage(who, &usage);
    seconds += GetSeconds(usage.ru_utime) + GetSeconds(usage.ru_stime);
  }
  return seconds;
}

CoreTimes ReadCoreTimes(const Cores& cores)
{
  return ParseCoreTimes(ReadFile("/proc/stat"), cores);
}
} // namespace

Cores ParseCores(const std::string& list)
{
  Cores cores;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');)
  {
    std::istringstream range(part);
    int first;
    if (range >> first)
    {
      int last = first;
      range.ignore(1, '-');
      range >> last;
      for (int core = first; core <= std::max(first, last); ++core)
      {
        cores.insert(core);
      }
    }
  }
  return cores;
}

Cores ChooseCores(
  const Cores& allowed, const std::function<Cores(int core)>& getSiblings, int count)
{
  const std::size_t wanted =
    count == 0 ? allowed.size() : std::min(allowed.size(), static_cast<std::size_t>(count));
  Cores chosen;
  Cores shared;
  for (bool mayShare : { false, true })
  {
    for (auto core = allowed.rbegin(); core != allowed.rend() && chosen.size() < wanted; ++core)
    {
      if (mayShare || shared.count(*core) == 0)
      {
        chosen.insert(*core);
        shared.merge(getSiblings(*core));
      }
    }
  }
  return chosen;
}

std::string ReserveCores(int count)
{
  static const Cores allowed = GetAllowedCores();
  const Cores chosen = ChooseCores(allowed, &GetSiblings, count);
  cpu_set_t set;
  CPU_ZERO(&set);
  for (int core : chosen)
  {
    CPU_SET(core, &set);
  }
  std::string text = sched_setaffinity(0, sizeof set, &set) == 0
    ? "Bound to the cores " + Join(chosen) + ", "
    : std::string("Not bound to cores (") + std::strerror(errno) + "), ";
  sched_param priority = {};
  priority.sched_priority = sched_get_priority_min(SCHED_FIFO);
  text += sched_setscheduler(0, SCHED_FIFO, &priority) == 0
    ? "with real-time priority."
    : std::string("without real-time priority (") + std::strerror(errno) + ").";
  return text;
}

CoreTimes ParseCoreTimes(const std::string& text, const Cores& cores)
{
  // The columns of proc(5): user, nice, system, idle, iowait, irq, softirq, steal.
  constexpr std::array<bool, 8> IsBusy = { true, true, true, false, false, true, true, true };
  CoreTimes times;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string name;
    words >> name;
    const Cores named = ParseCores(name.substr(std::min<std::size_t>(name.size(), 3)));
    if (name.compare(0, 3, "cpu") != 0 || named.size() != 1 || cores.count(*named.begin()) == 0)
    {
      continue;
    }
    double time;
    for (std::size_t column = 0; column < IsBusy.size() && words >> time; ++column)
    {
      times.All += time;
      times.Busy += IsBusy[column] ? time : 0.0;
    }
  }
  return times;
}

LoadMeter::LoadMeter()
  : Measured(GetAllowedCores())
  , Start(ReadCoreTimes(this->Measured))
  , OwnStart(GetOwnSeconds())
{
}

double LoadMeter::GetShareOfOthers() const
{
  const double own = (GetOwnSeconds() - this->OwnStart) * static_cast<double>(sysconf(_SC_CLK_TCK));
  const CoreTimes now = ReadCoreTimes(this->Measured);
  const double all = now.All - this->Start.All;
  return all > 0.0 ? std::clamp((now.Busy - this->Start.Busy - own) / all, 0.0, 1.0)
                   : std::numeric_limits<double>::quiet_NaN();
}

std::string DescribeOthers(double share)
{
  if (!(share > ShareWhenQuiet))
  {
    return "";
  }
  return "The machine was not quiet: other processes took " +
    std::to_string(std::lround(100.0 * share)) + " % of the cores' time.";
}
