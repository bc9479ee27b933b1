// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dListeners.h"

#include "lms3dLog.h"

#include <chrono>
#include <string>

namespace
{
constexpr int MostFailures = 3;
constexpr CORBA::ULong CallMilliseconds = 500;
} // namespace

lms3dListeners::lms3dListeners(const lms3dSnapshotStore& store)
  : Store(store)
{
}

lms3dListeners::~lms3dListeners()
{
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void lms3dListeners::Start()
{
  this->Thread = std::thread([this] { this->Run(); });
}

CORBA::ULong lms3dListeners::Add(LMS3D::ScanListener_ptr listener)
{
  omniORB::setClientCallTimeout(listener, CallMilliseconds);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Listeners.size() == Most)
  {
    return 0;
  }
  this->Listeners[++this->Last].Reference = LMS3D::ScanListener::_duplicate(listener);
  return this->Last;
}

bool lms3dListeners::Remove(CORBA::ULong subscription)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Listeners.erase(subscription) != 0;
}

std::size_t lms3dListeners::GetNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Listeners.size();
}

void lms3dListeners::Run()
{
  std::uint64_t told = 0;
  while (!this->Store.IsStopped())
  {
    const auto later = lms3dSnapshotStore::Clock::now() + std::chrono::hours(1);
    const lms3dSnapshotPointer snapshot = this->Store.Wait(told, 0, later);
    if (!snapshot)
    {
      continue;
    }
    told = snapshot->Header.number;
    // A copy, since a call may take its time and subscriptions come and go meanwhile.
    std::map<CORBA::ULong, Listener> listeners;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      listeners = this->Listeners;
    }
    for (const auto& listener : listeners)
    {
      this->Tell(listener.first, listener.second.Reference, snapshot->Header);
    }
  }
}

void lms3dListeners::Tell(
  CORBA::ULong subscription, LMS3D::ScanListener_ptr listener, const LMS3D::ScanHeader& header)
{
  if (this->Store.IsStopped())
  {
    return;
  }
  try
  {
    listener->scanReady(header);
    this->Count(subscription, true);
  }
  catch (const CORBA::Exception&)
  {
    this->Count(subscription, false);
  }
}

void lms3dListeners::Count(CORBA::ULong subscription, bool isReached)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto listener = this->Listeners.find(subscription);
  if (listener == this->Listeners.end())
  {
    return;
  }
  listener->second.Failures = isReached ? 0 : listener->second.Failures + 1;
  if (listener->second.Failures == MostFailures)
  {
    this->Listeners.erase(listener);
    lms3dLog("listener " + std::to_string(subscription) + " cannot be reached and is left out");
  }
}
