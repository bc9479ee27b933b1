// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRemoteWatch.h"

#include <exception>
#include <utility>

namespace
{
// How long a pose may wait to be sent, and how long Stop() takes with a server that answers.
constexpr std::uint32_t LongestWait = 200;

// How soon a server that has come back is noticed.
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
      this->Report(this->News.Problem, problem.what());
      this->Pause();
    }
    catch (const CORBA::Exception& exception)
    {
      this->Report(this->News.Problem, std::string("CORBA does not work: ") + exception._name());
      this->Pause();
    }
  }
}

// Until something fails.
void lms3dRemoteWatch::Follow()
{
  lms3dRemoteServer server(this->Url, this->Timeout);
  while (!this->IsStopped())
  {
    this->SendWaitingPose(server);
    if (lms3dRemoteScanPointer scan = server.WaitForScan(LongestWait))
    {
      this->Publish(std::move(scan));
    }
    else
    {
      this->Report(this->News.Problem, server.GetProblem());
    }
  }
}

void lms3dRemoteWatch::SendWaitingPose(lms3dRemoteServer& server)
{
  std::optional<LMS3D::Pose> pose;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    pose.swap(this->WaitingPose);
  }
  if (!pose)
  {
    return;
  }
  try
  {
    server.SetPose(*pose);
    this->Report(this->News.Refusal, "");
  }
  catch (const std::exception& refusal)
  {
    this->Report(this->News.Refusal, refusal.what());
  }
}

void lms3dRemoteWatch::Publish(lms3dRemoteScanPointer scan)
{
  this->Report(this->News.Problem, "");
  // Freed after the lock.
  lms3dRemoteScanPointer displaced;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    // After a pause the newest may be the one from before.
    if (this->News.Scan && IsSameScan(*this->News.Scan, *scan))
    {
      return;
    }
    displaced = std::exchange(this->News.Scan, std::move(scan));
    ++this->News.Count;
  }
  this->Changed.notify_all();
}

void lms3dRemoteWatch::Report(std::string& place, const std::string& text)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (place == text)
    {
      return;
    }
    place = text;
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
  this->Changed.wait_for(lock, this->Timeout, [this] { return this->News.Count > 0; });
  return this->News;
}

void lms3dRemoteWatch::SendPose(const LMS3D::Pose& pose)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->WaitingPose = pose;
}
