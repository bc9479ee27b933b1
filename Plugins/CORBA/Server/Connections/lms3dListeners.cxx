// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dListeners.h"

#include "lms3dObjectAddresses.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>
#include <vector>

namespace
{
// The first: clients that name many have them all in the same order.
std::string GetAddress(LMS3D::ScanListener_ptr reference)
{
  const std::vector<std::string> addresses = lms3dGetAddresses(reference);
  return addresses.empty() ? "no address" : addresses.front();
}
} // namespace

lms3dListeners::lms3dListeners(const lms3dSnapshotStore& store)
  : Store(store)
{
}

lms3dListeners::~lms3dListeners()
{
  this->Stop();
}

void lms3dListeners::Start()
{
  this->Thread = std::thread([this] { this->Run(); });
}

void lms3dListeners::Stop()
{
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  Table all;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
    all.swap(this->Listeners);
  }
  // All of them before the first is waited for.
  for (const auto& listener : all)
  {
    listener.second->Stop();
  }
}

CORBA::ULong lms3dListeners::Add(LMS3D::ScanListener_ptr reference)
{
  const std::string address = GetAddress(reference);
  const Table leftOut = this->TakeThoseLeftOut();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Stopped)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  this->RequireRoom(address);
  const CORBA::ULong subscription = this->MakeNumber();
  this->Listeners[subscription] = std::make_unique<lms3dListener>(reference, address);
  return subscription;
}

bool lms3dListeners::Remove(CORBA::ULong subscription)
{
  // Outlives the lock, since its end may wait for a call.
  Table::node_type removed;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  removed = this->Listeners.extract(subscription);
  return !removed.empty() && !removed.mapped()->IsLeftOut();
}

std::size_t lms3dListeners::GetNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::count_if(this->Listeners.begin(), this->Listeners.end(),
    [](const auto& listener) { return !listener.second->IsLeftOut(); });
}

void lms3dListeners::Run()
{
  std::uint64_t told = 0;
  while (!this->Store.IsStopped())
  {
    const auto later = lms3dSnapshotStore::Clock::now() + std::chrono::hours(1);
    if (const lms3dSnapshotPointer snapshot = this->Store.Wait(told, 0, later))
    {
      told = snapshot->Header.number;
      this->TellAll(snapshot->Header);
    }
  }
}

void lms3dListeners::TellAll(const LMS3D::ScanHeader& header)
{
  const Table leftOut = this->TakeThoseLeftOut();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (const auto& listener : this->Listeners)
  {
    listener.second->Tell(header);
  }
}

lms3dListeners::Table lms3dListeners::TakeThoseLeftOut()
{
  Table leftOut;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (auto listener = this->Listeners.begin(); listener != this->Listeners.end();)
  {
    const auto next = std::next(listener);
    if (listener->second->IsLeftOut())
    {
      leftOut.insert(this->Listeners.extract(listener));
    }
    listener = next;
  }
  return leftOut;
}

void lms3dListeners::RequireRoom(const std::string& address) const
{
  const auto ofAddress = std::count_if(this->Listeners.begin(), this->Listeners.end(),
    [&address](const auto& listener) { return listener.second->GetAddress() == address; });
  if (ofAddress == MostOfAddress)
  {
    throw LMS3D::LimitExceeded("too many listeners of one client", MostOfAddress);
  }
  if (this->Listeners.size() == Most)
  {
    throw LMS3D::LimitExceeded("too many listeners", Most);
  }
}

CORBA::ULong lms3dListeners::MakeNumber() const
{
  std::random_device random;
  CORBA::ULong number = random();
  while (this->Listeners.count(number) != 0)
  {
    number = random();
  }
  return number;
}
