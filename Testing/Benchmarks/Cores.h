// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cores that a benchmark measures on: how it gets them, and what else uses them (Linux).
 */
#ifndef Cores_h
#define Cores_h

#include <functional>
#include <set>
#include <string>

/// Numbers of logical cores, as the system counts them.
using Cores = std::set<int>;

/// Reads a list such as "0-2,5".
Cores ParseCores(const std::string& list);

/// Chooses some of the allowed cores, from the highest number down, because interrupts prefer low
/// numbers. `getSiblings` returns the logical cores that share a core's hardware. Two of them are
/// chosen only if there are not enough others. `count` is at least 1; 0 stands for all allowed
/// cores.
Cores ChooseCores(
  const Cores& allowed, const std::function<Cores(int core)>& getSiblings, int count);

/**
 * Binds this process to some of the cores it had at the first call, and requests the priority of a
 * real-time process, which ordinary processes cannot interrupt. `count` is that of ChooseCores.
 * Returns a sentence about cores and priority. Threads that run already are not bound.
 */
std::string ReserveCores(int count);

/// The time of some cores since the system started, in its own units.
struct CoreTimes
{
  double Busy = 0.0;
  double All = 0.0;
};

/// Sums the times of some cores in the text of /proc/stat. Waiting for a disk is not busy.
CoreTimes ParseCoreTimes(const std::string& text, const Cores& cores);

/// Measures what other processes take of this process's cores, from its construction on.
class LoadMeter
{
public:
  LoadMeter();

  /// Returns their share of the cores' time, from 0 to 1. Child processes that have ended are not
  /// others. The result is NaN if the system does not report it.
  double GetShareOfOthers() const;

private:
  Cores Measured;
  CoreTimes Start;
  double OwnStart;
};

/// If other processes take a larger share, the machine is not quiet.
constexpr double ShareWhenQuiet = 0.03;

/// Returns a sentence about a share, empty if the machine was quiet.
std::string DescribeOthers(double share);

#endif
