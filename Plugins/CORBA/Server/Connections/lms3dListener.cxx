// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dListener.h"

#include "Common/lms3dLog.h"

namespace
{
// In a row.
constexpr int MaximumFailures = 3;

// Connecting and forwards count too; see lms3dLimitRetries().
constexpr CORBA::ULong CallMilliseconds = 500;

// A reference to the same object. The ORB locates an object only before the first call of a
// reference, and notices an object that does not exist, or that forwards all calls, only then:
// scanReady() has no answer.
LMS3D::ScanListener_ptr MakeReference(LMS3D::ScanListener_ptr reference)
{
  cdrMemoryStream stream;
  LMS3D::ScanListener::_marshalObjRef(reference, stream);
  LMS3D::ScanListener_ptr anew = LMS3D::ScanListener::_unmarshalObjRef(stream);
  omniORB::setClientCallTimeout(anew, CallMilliseconds);
  return anew;
}
} // namespace

lms3dListener::lms3dListener(LMS3D::ScanListener_ptr reference, const std::string& address)
  : Reference(MakeReference(reference))
  , Address(address)
{
  this->Thread = std::thread([this] { this->Run(); });
}

lms3dListener::~lms3dListener()
{
  this->Stop();
  this->Thread.join();
}

void lms3dListener::Notify(const LMS3D::ScanHeader& header)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Newest = header;
    this->IsPending = true;
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

bool lms3dListener::HasFailed() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Failed;
}

bool lms3dListener::HasEnded() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Ended;
}

void lms3dListener::Run()
{
  const bool hasFailed = this->CallUntilFailure();
  if (hasFailed)
  {
    lms3dLog(
      lms3dLogKind::Listeners, "a listener cannot be reached and is dropped: " + this->Address);
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Failed = hasFailed;
  this->Ended = true;
}

bool lms3dListener::CallUntilFailure()
{
  int failures = 0;
  LMS3D::ScanHeader header;
  while (failures < MaximumFailures && this->WaitForHeader(header))
  {
    failures = this->Call(header, failures != 0) ? 0 : failures + 1;
  }
  return failures == MaximumFailures;
}

bool lms3dListener::WaitForHeader(LMS3D::ScanHeader& header)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return this->IsPending || this->Stopped; });
  header = this->Newest;
  this->IsPending = false;
  return !this->Stopped;
}

bool lms3dListener::Call(const LMS3D::ScanHeader& header, bool isRetry)
{
  try
  {
    if (isRetry)
    {
      this->Reference = MakeReference(this->Reference);
    }
    this->Reference->scanReady(header);
    return true;
  }
  catch (const CORBA::Exception&)
  {
    return false;
  }
  catch (const omniORB::fatalException& problem)
  {
    lms3dLog(lms3dLogKind::Listeners, std::string("the ORB failed: ") + problem.errmsg());
    return false;
  }
}
