// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Punctuality.h"

#include <algorithm>

namespace
{
constexpr CORBA::ULong WaitMilliseconds = 1000;
constexpr double Nanosecond = 1e-9;
} // namespace

Punctuality::Punctuality(LMS3D::LaserScanner_ptr scanner)
  : Scanner(LMS3D::LaserScanner::_duplicate(scanner))
  , Watcher([this] { this->Watch(); })
{
}

Punctuality::~Punctuality()
{
  this->Stop();
}

void Punctuality::Stop()
{
  this->Stopped = true;
  if (this->Watcher.joinable())
  {
    this->Watcher.join();
  }
}

void Punctuality::Watch()
{
  std::uint64_t seen = 0;
  std::uint64_t first = 0;
  while (!this->Stopped)
  {
    try
    {
      const LMS3D::ScanHeader_var header = this->Scanner->waitForScan(seen, 0, WaitMilliseconds);
      seen = header->number;
      first = first == 0 ? header->startTime : first;
      this->Begins.push_back({ seen, Nanosecond * static_cast<double>(header->startTime - first) });
    }
    catch (const LMS3D::NoScanYet&)
    {
      // A slow scan: wait on.
    }
  }
}

double Punctuality::GetScansPerSecond() const
{
  if (this->Begins.size() < 2)
  {
    return 0.0;
  }
  const Begin& first = this->Begins.front();
  const Begin& last = this->Begins.back();
  return static_cast<double>(last.Number - first.Number) / (last.Time - first.Time);
}

std::vector<double> Punctuality::GetLateness(double rate) const
{
  std::vector<double> lateness;
  lateness.reserve(this->Begins.size());
  const double period = 1.0 / rate;
  std::uint64_t number = 0;
  double due = 0.0;
  double earliest = 0.0;
  for (const Begin& begin : this->Begins)
  {
    due = number == 0 ? begin.Time : due + period * static_cast<double>(begin.Number - number);
    number = begin.Number;
    lateness.push_back(begin.Time - due);
    earliest = std::min(earliest, lateness.back());
    if (lateness.back() - earliest >= period)
    {
      due = begin.Time;
    }
  }
  constexpr double Milliseconds = 1000.0;
  std::transform(lateness.begin(), lateness.end(), lateness.begin(),
    [earliest](double late) { return Milliseconds * (late - earliest); });
  return lateness;
}
