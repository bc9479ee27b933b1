// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/lms3dRemoteWatch.h"

#include <exception>
#include <utility>

namespace
{
// Milliseconds until a pose is sent, and until Run() returns if the server answers.
constexpr std::uint32_t MaximumWait = 200;

// Time until a restarted server is noticed.
constexpr std::chrono::milliseconds RetryInterval(500);

bool IsSameScan(const lms3dRemoteScan& a, const lms3dRemoteScan& b)
{
  return a.Header.incarnation == b.Header.incarnation && a.Header.number == b.Header.number;
}
} // namespace

lms3dRemoteWatch::lms3dRemoteWatch(std::string url, std::chrono::milliseconds timeout)
  : Url(std::move(url))
  , Timeout(timeout)
{
}

void lms3dRemoteWatch::Run()
{
  while (!this->IsStopped())
  {
    try
    {
      this->Follow();
    }
    catch (const std::exception& problem)
    {
      this->ReportProblem(problem.what());
      this->Pause();
    }
    catch (const CORBA::Exception& exception)
    {
      this->ReportProblem(std::string("CORBA failed: ") + exception._name());
      this->Pause();
    }
  }
}

// Runs until a request fails.
void lms3dRemoteWatch::Follow()
{
  lms3dRemoteServer server(this->Url, this->Timeout, [this] { return this->IsStopped(); });
  this->AnsweredPose = 0;
  while (!this->IsStopped())
  {
    this->SendPendingPose(server);
    if (lms3dRemoteScanPointer scan = server.WaitForScan(MaximumWait))
    {
      const FusedMapNews fusedMap = this->FetchFusedMap(server);
      this->Publish(std::move(scan), fusedMap);
    }
    else
    {
      this->ReportProblem(server.GetProblem());
    }
  }
}

lms3dRemoteWatch::FusedMapNews lms3dRemoteWatch::FetchFusedMap(lms3dRemoteServer& server) const
{
  FusedMapNews news;
  news.IsWanted = this->FusedMapWanted;
  if (!news.IsWanted)
  {
    return news;
  }
  try
  {
    news.Map = server.FetchFusedMap();
    news.Problem = server.GetFusedMapProblem();
  }
  // The scan is there all the same. If the server is gone, the next call notices this.
  catch (const std::exception& problem)
  {
    news.Problem = problem.what();
  }
  return news;
}

void lms3dRemoteWatch::SendPendingPose(lms3dRemoteServer& server)
{
  LMS3D::Pose pose{};
  std::uint64_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->News.IsPosePending || this->PoseNumber == this->AnsweredPose)
    {
      return;
    }
    pose = this->Pose;
    number = this->PoseNumber;
  }
  try
  {
    this->PoseGeneration = server.SetPose(pose);
  }
  catch (const lms3dRemoteRefusal& refusal)
  {
    this->TakeRefusal(number, refusal.what());
  }
  this->AnsweredPose = number;
}

void lms3dRemoteWatch::TakeRefusal(std::uint64_t number, const std::string& refusal)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (number != this->PoseNumber)
    {
      return;
    }
    this->News.Refusal = refusal;
    this->News.IsPosePending = false;
    ++this->News.Count;
  }
  this->Changed.notify_all();
}

void lms3dRemoteWatch::Publish(lms3dRemoteScanPointer scan, const FusedMapNews& fusedMap)
{
  this->ReportProblem("");
  // Freed after unlocking.
  lms3dRemoteScanPointer displaced;
  lms3dRemoteFusedMapPointer displacedMap;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    displacedMap = this->ReplaceFusedMap(fusedMap);
    // After reconnecting, the newest scan may be the same as before.
    if (!this->News.Scan || !IsSameScan(*this->News.Scan, *scan))
    {
      const bool isFromPose =
        this->AnsweredPose == this->PoseNumber && scan->Header.generation >= this->PoseGeneration;
      this->News.IsPosePending = this->News.IsPosePending && !isFromPose;
      displaced = std::exchange(this->News.Scan, std::move(scan));
      ++this->News.Scans;
      ++this->News.Count;
    }
  }
  this->Changed.notify_all();
}

lms3dRemoteFusedMapPointer lms3dRemoteWatch::ReplaceFusedMap(const FusedMapNews& fusedMap)
{
  const bool isReplaced = fusedMap.Map || !fusedMap.IsWanted;
  lms3dRemoteFusedMapPointer map = isReplaced ? fusedMap.Map : this->News.FusedMap;
  if (map != this->News.FusedMap || fusedMap.Problem != this->News.FusedMapProblem)
  {
    this->News.FusedMapProblem = fusedMap.Problem;
    ++this->News.Count;
  }
  return std::exchange(this->News.FusedMap, std::move(map));
}

void lms3dRemoteWatch::ReportProblem(const std::string& problem)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->News.Problem == problem)
    {
      return;
    }
    this->News.Problem = problem;
    ++this->News.Count;
  }
  this->Changed.notify_all();
}

void lms3dRemoteWatch::Pause() const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait_for(lock, RetryInterval, [this] { return this->Stopped; });
}

void lms3dRemoteWatch::Stop()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
  }
  this->Changed.notify_all();
}

bool lms3dRemoteWatch::IsStopped() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Stopped;
}

std::uint64_t lms3dRemoteWatch::GetCount() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->News.Count;
}

lms3dRemoteNews lms3dRemoteWatch::GetNews() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->News;
}

lms3dRemoteNews lms3dRemoteWatch::WaitForNews() const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait_for(lock, this->Timeout,
    [this]
    { return this->News.Scan || !this->News.Problem.empty() || !this->News.Refusal.empty(); });
  return this->News;
}

bool lms3dRemoteWatch::WaitForScan(std::uint64_t scans) const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  return this->Changed.wait_for(lock, this->Timeout,
    [this, scans] { return this->News.Scans > scans && !this->News.IsPosePending; });
}

void lms3dRemoteWatch::SendPose(const LMS3D::Pose& pose)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Pose = pose;
  ++this->PoseNumber;
  this->News.Refusal.clear();
  this->News.IsPosePending = true;
  ++this->News.Count;
}
