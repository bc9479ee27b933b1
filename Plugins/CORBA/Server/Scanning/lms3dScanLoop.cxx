// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dScanLoop.h"

#include "Common/lms3dLog.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <malloc.h>

namespace
{
// If every scan fails, a loop without pauses must not spin.
constexpr std::chrono::milliseconds PauseAfterProblem(100);

// A scan is not aborted before this time, because it may be complete soon. The number of aborted
// scans in a row is limited, so that clients that change settings all the time still get scans.
constexpr std::chrono::milliseconds LongScan(100);
constexpr int MaximumAbortedInARow = 2;

std::uint64_t NanosecondsSince1970()
{
  using namespace std::chrono;
  return static_cast<std::uint64_t>(
    duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count());
}

std::chrono::steady_clock::duration GetPeriod(double rate)
{
  using Duration = std::chrono::steady_clock::duration;
  return rate > 0.0
    ? std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1.0 / rate))
    : Duration::zero();
}
} // namespace

lms3dScanLoop::lms3dScanLoop(
  lms3dSettingsBoard& board, lms3dSnapshotStore& store, double rate, int threads)
  : Board(board)
  , Store(store)
  , Period(GetPeriod(rate))
  , Incarnation(NanosecondsSince1970())
  , Pipeline(threads)
{
}

lms3dScanLoop::~lms3dScanLoop()
{
  this->Stop();
}

void lms3dScanLoop::MakeFusedMap(const lms3dFusedMapOptions& options, lms3dFusedMapStore& store)
{
  this->FusedMap = std::make_unique<lms3dFusedMapMaker>(options, this->Incarnation, store);
  this->Pipeline.FindLostBeams();
}

void lms3dScanLoop::Start()
{
  this->Thread = std::thread([this] { this->Run(); });
}

void lms3dScanLoop::Stop()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
  }
  this->Pipeline.Stop();
  if (this->FusedMap)
  {
    this->FusedMap->Stop();
  }
  this->Board.Stop();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void lms3dScanLoop::Run()
{
  Clock::time_point due = Clock::now();
  while (this->SleepUntil(due))
  {
    // Earlier if new settings begin the scan.
    due = std::min(due, Clock::now());
    try
    {
      if (this->MakeScan())
      {
        this->SetProblem("");
        this->ReleaseMemory();
      }
    }
    catch (const std::exception& problem)
    {
      this->SetProblem(problem.what());
      due = std::max(due, Clock::now() + PauseAfterProblem - this->Period);
    }
    due = this->GetNext(due);
  }
}

bool lms3dScanLoop::MakeScan()
{
  const std::uint64_t start = NanosecondsSince1970();
  const lms3dScanSettings settings = this->Board.Get();
  this->Generation = settings.Generation;
  const Clock::time_point longAfter = Clock::now() + LongScan;
  const bool mayAbort = this->AbortedInARow < MaximumAbortedInARow;
  std::shared_ptr<lms3dSnapshot> snapshot = this->Pipeline.Run(settings, this->Number + 1,
    [this, mayAbort, longAfter, generation = settings.Generation]
    { return mayAbort && Clock::now() > longAfter && this->Board.GetGeneration() != generation; });
  if (!snapshot)
  {
    ++this->AbortedInARow;
    return false;
  }
  this->AbortedInARow = 0;
  ++this->Number;
  if (this->FusedMap)
  {
    this->Pipeline.AddTo(*this->FusedMap, settings, this->Number);
  }
  snapshot->Header.incarnation = this->Incarnation;
  snapshot->Header.startTime = start;
  snapshot->Header.endTime = NanosecondsSince1970();
  this->Store.Publish(std::move(snapshot));
  return true;
}

// The allocator keeps the freed memory of large scans in pieces between small ones. Returning it
// takes some milliseconds, so this is done only after much has become free.
void lms3dScanLoop::ReleaseMemory()
{
  constexpr std::size_t Minimum = std::size_t(64) << 20;
  const std::size_t bytes = this->Store.GetBytes();
  this->MaximumBytes = std::max(this->MaximumBytes, bytes);
  if (this->MaximumBytes > Minimum && bytes < this->MaximumBytes / lms3dScanPipeline::ReleaseFactor)
  {
    malloc_trim(0);
    this->MaximumBytes = bytes;
  }
}

// After a delay of a period or more, counts from now on instead of catching up with a burst of
// scans.
lms3dScanLoop::Clock::time_point lms3dScanLoop::GetNext(Clock::time_point due)
{
  const Clock::time_point next = due + this->Period;
  const Clock::time_point now = Clock::now();
  if (this->Period == Clock::duration::zero() || now - next < this->Period)
  {
    return next;
  }
  ++this->LateScans;
  return now;
}

bool lms3dScanLoop::SleepUntil(Clock::time_point time)
{
  this->Board.WaitForChange(this->Generation, time);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return !this->Stopped;
}

std::string lms3dScanLoop::GetProblem() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Problem;
}

void lms3dScanLoop::SetProblem(const std::string& problem)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Problem == problem || this->Stopped)
    {
      return;
    }
    this->Problem = problem;
  }
  lms3dLog(lms3dLogKind::Scans, problem.empty() ? "scanning again" : "no scan: " + problem);
}
