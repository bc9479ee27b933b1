// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dListeners.h"

#include "Announcement/lms3dObjectAddresses.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>
#include <vector>

namespace
{
// The first one: a client's references list its addresses in the same order.
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
  // Stops all before their destructors wait for one after the other.
  for (const auto& listener : all)
  {
    listener.second->Stop();
  }
}

CORBA::ULong lms3dListeners::Add(LMS3D::ScanListener_ptr reference)
{
  const std::string address = GetAddress(reference);
  const Table failed = this->TakeFailed();
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
  // Outlives the lock, because its destructor may wait for a call.
  Table::node_type removed;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  removed = this->Listeners.extract(subscription);
  return !removed.empty() && !removed.mapped()->HasFailed();
}

std::size_t lms3dListeners::GetNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::count_if(this->Listeners.begin(), this->Listeners.end(),
    [](const auto& listener) { return !listener.second->HasFailed(); });
}

void lms3dListeners::Run()
{
  std::uint64_t newest = 0;
  while (!this->Store.IsStopped())
  {
    const auto later = lms3dSnapshotStore::Clock::now() + std::chrono::hours(1);
    if (const lms3dSnapshotPointer snapshot = this->Store.Wait(newest, 0, later))
    {
      newest = snapshot->Header.number;
      this->NotifyAll(snapshot->Header);
    }
  }
}

void lms3dListeners::NotifyAll(const LMS3D::ScanHeader& header)
{
  const Table failed = this->TakeFailed();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (const auto& listener : this->Listeners)
  {
    listener.second->Notify(header);
  }
}

lms3dListeners::Table lms3dListeners::TakeFailed()
{
  Table failed;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (auto listener = this->Listeners.begin(); listener != this->Listeners.end();)
  {
    const auto next = std::next(listener);
    if (listener->second->HasFailed())
    {
      failed.insert(this->Listeners.extract(listener));
    }
    listener = next;
  }
  return failed;
}

void lms3dListeners::RequireRoom(const std::string& address) const
{
  const auto sameAddress = std::count_if(this->Listeners.begin(), this->Listeners.end(),
    [&address](const auto& listener) { return listener.second->GetAddress() == address; });
  if (sameAddress == MaximumPerAddress)
  {
    throw LMS3D::LimitExceeded("too many listeners of one client", MaximumPerAddress);
  }
  if (this->Listeners.size() == Maximum)
  {
    throw LMS3D::LimitExceeded("too many listeners", Maximum);
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
