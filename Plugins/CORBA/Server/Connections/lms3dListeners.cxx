// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dListeners.h"

#include "Announcement/lms3dObjectAddresses.h"
#include "Common/lms3dLog.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <random>
#include <system_error>
#include <utility>

namespace
{
// The ORB would connect to other transports, too: to Unix sockets of this machine.
void RequireNetwork(const std::vector<std::string>& addresses)
{
  const auto other = std::find_if_not(addresses.begin(), addresses.end(), lms3dIsNetworkAddress);
  if (other != addresses.end() || addresses.empty())
  {
    const std::string reason = addresses.empty()
      ? "the listener has no usable TCP or TLS address"
      : "the listener has an address that is neither TCP nor TLS";
    lms3dLog(lms3dLogKind::Listeners,
      "a subscription is refused: " + reason + (addresses.empty() ? "" : ": " + *other));
    throw LMS3D::InvalidArgument(reason.c_str());
  }
}

// The first one: a client's references list its addresses in the same order.
std::string GetAddress(LMS3D::ScanListener_ptr reference)
{
  const std::vector<std::string> addresses = lms3dGetAddresses(reference);
  RequireNetwork(addresses);
  return addresses.front();
}

// Its thread may be one more than the system gives.
std::unique_ptr<lms3dListener> MakeListener(
  LMS3D::ScanListener_ptr reference, const std::string& address)
{
  try
  {
    return std::make_unique<lms3dListener>(reference, address);
  }
  catch (const std::system_error& problem)
  {
    lms3dLog(lms3dLogKind::Listeners,
      std::string("a subscription is refused: there is no thread for it: ") + problem.what());
    throw CORBA::NO_RESOURCES(0, CORBA::COMPLETED_NO);
  }
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
  List all;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
    all.swap(this->Ending);
    for (auto& listener : this->Listeners)
    {
      all.push_back(std::move(listener.second));
    }
    this->Listeners.clear();
  }
  // Stops all before their destructors wait for one after the other.
  for (const auto& listener : all)
  {
    listener->Stop();
  }
}

CORBA::ULong lms3dListeners::Add(LMS3D::ScanListener_ptr reference)
{
  const std::string address = GetAddress(reference);
  const List ended = this->TakeEnded();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Stopped)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  this->RequireRoom(address);
  const CORBA::ULong subscription = this->MakeNumber();
  this->Listeners[subscription] = MakeListener(reference, address);
  return subscription;
}

bool lms3dListeners::Remove(CORBA::ULong subscription)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->RemoveFailed();
  const auto removed = this->Listeners.extract(subscription);
  if (removed.empty())
  {
    return false;
  }
  removed.mapped()->Stop();
  this->Ending.push_back(std::move(removed.mapped()));
  return true;
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
  const List ended = this->TakeEnded();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (const auto& listener : this->Listeners)
  {
    listener.second->Notify(header);
  }
}

lms3dListeners::List lms3dListeners::TakeEnded()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->RemoveFailed();
  const auto first = std::partition(this->Ending.begin(), this->Ending.end(),
    [](const auto& listener) { return !listener->HasEnded(); });
  List ended(std::make_move_iterator(first), std::make_move_iterator(this->Ending.end()));
  this->Ending.erase(first, this->Ending.end());
  return ended;
}

void lms3dListeners::RemoveFailed()
{
  for (auto listener = this->Listeners.begin(); listener != this->Listeners.end();)
  {
    if (listener->second->HasFailed())
    {
      this->Ending.push_back(std::move(listener->second));
      listener = this->Listeners.erase(listener);
    }
    else
    {
      ++listener;
    }
  }
}

void lms3dListeners::RequireRoom(const std::string& address) const
{
  std::size_t sameAddress = 0;
  for (const auto& listener : this->Listeners)
  {
    sameAddress += listener.second->GetAddress() == address ? 1 : 0;
  }
  for (const auto& listener : this->Ending)
  {
    sameAddress += listener->GetAddress() == address ? 1 : 0;
  }
  if (sameAddress >= MaximumPerAddress)
  {
    throw LMS3D::LimitExceeded("too many listeners of one client", MaximumPerAddress);
  }
  if (this->Listeners.size() + this->Ending.size() >= Maximum)
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
