// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dWaitingRoom.h"

#include <algorithm>

namespace
{
using Clock = lms3dSnapshotStore::Clock;

// Of looking for clients that have gone.
constexpr std::chrono::milliseconds LookPeriod(500);

constexpr std::chrono::seconds FirstScanWait(5);
} // namespace

class lms3dWaitingRoom::Place
{
public:
  explicit Place(lms3dWaitingRoom& room)
    : Room(room)
  {
    const std::lock_guard<std::mutex> lock(room.Mutex);
    if (room.Waiting.size() >= Most)
    {
      throw LMS3D::LimitExceeded("too many clients wait for a scan", Most);
    }
    if (room.Waiting.count(lms3dGetCaller()) >= MostOfConnection)
    {
      throw LMS3D::LimitExceeded(
        "too many calls of this connection wait for a scan", MostOfConnection);
    }
    room.Waiting.insert(lms3dGetCaller());
  }
  ~Place()
  {
    const std::lock_guard<std::mutex> lock(this->Room.Mutex);
    this->Room.Waiting.erase(this->Room.Waiting.find(lms3dGetCaller()));
  }
  Place(const Place&) = delete;
  void operator=(const Place&) = delete;

private:
  lms3dWaitingRoom& Room;
};

lms3dWaitingRoom::lms3dWaitingRoom(const lms3dSnapshotStore& store)
  : Store(store)
{
}

lms3dSnapshotPointer lms3dWaitingRoom::Wait(
  std::uint64_t after, std::uint64_t generation, std::chrono::milliseconds longest)
{
  const Clock::time_point deadline = Clock::now() + longest;
  lms3dSnapshotPointer snapshot = this->Store.Wait(after, generation, Clock::now());
  if (snapshot)
  {
    return snapshot;
  }
  const Place place(*this);
  while (!snapshot && Clock::now() < deadline && !this->Store.IsStopped() && lms3dIsCallerThere())
  {
    snapshot = this->Store.Wait(after, generation, std::min(deadline, Clock::now() + LookPeriod));
  }
  return snapshot;
}

// The paper's operation declares no exceptions, so that without a place it is told to try again.
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
