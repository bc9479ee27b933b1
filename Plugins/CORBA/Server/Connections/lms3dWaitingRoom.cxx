// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dWaitingRoom.h"

#include <algorithm>

namespace
{
using Clock = lms3dSnapshotStore::Clock;

// How often a waiting call checks whether its client is still connected.
constexpr std::chrono::milliseconds CheckPeriod(500);

constexpr std::chrono::seconds FirstScanWait(5);
} // namespace

lms3dLimitedCall::lms3dLimitedCall(
  std::atomic<unsigned int>& count, unsigned int maximum, const char* reason)
  : Count(count)
{
  unsigned int others = count;
  do
  {
    if (others >= maximum)
    {
      throw LMS3D::LimitExceeded(reason, maximum);
    }
  } while (!count.compare_exchange_weak(others, others + 1));
}

class lms3dWaitingRoom::WaitingCall
{
public:
  explicit WaitingCall(lms3dWaitingRoom& room)
    : Room(room)
  {
    const std::lock_guard<std::mutex> lock(room.Mutex);
    if (room.Waiting.size() >= MaximumCalls)
    {
      throw LMS3D::LimitExceeded("too many clients wait for a scan", MaximumCalls);
    }
    if (room.Waiting.count(lms3dRequestGate::GetConnection()) >= MaximumCallsPerConnection)
    {
      throw LMS3D::LimitExceeded(
        "too many calls of this connection wait for a scan", MaximumCallsPerConnection);
    }
    room.Waiting.insert(lms3dRequestGate::GetConnection());
  }
  ~WaitingCall()
  {
    const std::lock_guard<std::mutex> lock(this->Room.Mutex);
    this->Room.Waiting.erase(this->Room.Waiting.find(lms3dRequestGate::GetConnection()));
  }
  WaitingCall(const WaitingCall&) = delete;
  void operator=(const WaitingCall&) = delete;

private:
  lms3dWaitingRoom& Room;
};

lms3dWaitingRoom::lms3dWaitingRoom(const lms3dSnapshotStore& store)
  : Store(store)
{
}

lms3dSnapshotPointer lms3dWaitingRoom::Wait(
  std::uint64_t after, std::uint64_t generation, std::chrono::milliseconds timeout)
{
  const Clock::time_point deadline = Clock::now() + timeout;
  lms3dSnapshotPointer snapshot = this->Store.Wait(after, generation, Clock::now());
  if (snapshot)
  {
    return snapshot;
  }
  const WaitingCall call(*this);
  while (!snapshot && Clock::now() < deadline && !this->Store.IsStopped() &&
    lms3dRequestGate::IsClientConnected())
  {
    snapshot = this->Store.Wait(after, generation, std::min(deadline, Clock::now() + CheckPeriod));
  }
  return snapshot;
}

// The paper's fetch() declares no exceptions, so without a place its client gets TRANSIENT.
lms3dSnapshotPointer lms3dWaitingRoom::WaitForFirst()
{
  lms3dSnapshotPointer first;
  try
  {
    first = this->Wait(0, 0, FirstScanWait);
  }
  catch (const LMS3D::LimitExceeded&)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  if (!first)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  return first;
}

std::size_t lms3dWaitingRoom::GetNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Waiting.size();
}
