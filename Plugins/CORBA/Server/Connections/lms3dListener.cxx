// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dListener.h"

#include "lms3dLog.h"

namespace
{
constexpr int MostFailures = 3;

// Those who end the server wait as long. The time to connect, which the ORB has for all objects
// together, must not be longer; see lms3dGetORBSettings().
constexpr CORBA::ULong CallMilliseconds = 500;
} // namespace

lms3dListener::lms3dListener(LMS3D::ScanListener_ptr reference, const std::string& address)
  : Reference(LMS3D::ScanListener::_duplicate(reference))
  , Address(address)
{
  omniORB::setClientCallTimeout(reference, CallMilliseconds);
  this->Thread = std::thread([this] { this->Run(); });
}

lms3dListener::~lms3dListener()
{
  this->Stop();
  this->Thread.join();
}

void lms3dListener::Tell(const LMS3D::ScanHeader& header)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->News = header;
    this->HasNews = true;
  }
  this->Changed.notify_one();
}

void lms3dListener::Stop()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
  }
  this->Changed.notify_one();
}

bool lms3dListener::IsLeftOut() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->LeftOut;
}

void lms3dListener::Run()
{
  int failures = 0;
  LMS3D::ScanHeader header;
  while (failures < MostFailures && this->WaitForNews(header))
  {
    failures = this->Reach(header) ? 0 : failures + 1;
  }
  if (failures == MostFailures)
  {
    lms3dLog("the listener at " + this->Address + " cannot be reached and is left out");
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->LeftOut = true;
  }
}

bool lms3dListener::WaitForNews(LMS3D::ScanHeader& header)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return this->HasNews || this->Stopped; });
  header = this->News;
  this->HasNews = false;
  return !this->Stopped;
}

bool lms3dListener::Reach(const LMS3D::ScanHeader& header) const
{
  try
  {
    this->Reference->scanReady(header);
    return true;
  }
  catch (const CORBA::Exception&)
  {
    return false;
  }
  catch (const omniORB::fatalException& problem)
  {
    lms3dLog(std::string("the ORB failed: ") + problem.errmsg());
    return false;
  }
}
