// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dSnapshotStore.h"

#include <utility>
#include <vector>

lms3dSnapshotStore::lms3dSnapshotStore(std::size_t keep, std::size_t maximumBytes)
  : Keep(keep)
  , MaximumBytes(maximumBytes)
{
}

void lms3dSnapshotStore::Publish(lms3dSnapshotPointer snapshot)
{
  // Declared before the lock, so that the memory is freed after unlocking.
  std::vector<lms3dSnapshotPointer> displaced;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Bytes += snapshot->GetBytes();
    this->Snapshots.push_back(std::move(snapshot));
    while (this->IsOverLimit())
    {
      this->Bytes -= this->Snapshots.front()->GetBytes();
      displaced.push_back(std::move(this->Snapshots.front()));
      this->Snapshots.pop_front();
    }
  }
  this->Changed.notify_all();
}

bool lms3dSnapshotStore::IsOverLimit() const
{
  const std::size_t number = this->Snapshots.size();
  return number > this->Keep || (number > 1 && this->Bytes > this->MaximumBytes);
}

lms3dSnapshotPointer lms3dSnapshotStore::GetNewest() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Snapshots.empty() ? nullptr : this->Snapshots.back();
}

std::uint64_t lms3dSnapshotStore::GetNewestNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Snapshots.empty() ? 0 : this->Snapshots.back()->Header.number;
}

std::uint64_t lms3dSnapshotStore::GetOldestNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Snapshots.empty() ? 0 : this->Snapshots.front()->Header.number;
}

std::size_t lms3dSnapshotStore::GetBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Bytes;
}

lms3dSnapshotPointer lms3dSnapshotStore::Find(std::uint64_t number) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Snapshots.empty() || number < this->Snapshots.front()->Header.number ||
    number > this->Snapshots.back()->Header.number)
  {
    return nullptr;
  }
  return this->Snapshots[number - this->Snapshots.front()->Header.number];
}

bool lms3dSnapshotStore::HasNewest(std::uint64_t after, std::uint64_t generation) const
{
  return !this->Snapshots.empty() && this->Snapshots.back()->Header.number > after &&
    this->Snapshots.back()->Header.generation >= generation;
}

lms3dSnapshotPointer lms3dSnapshotStore::Wait(
  std::uint64_t after, std::uint64_t generation, Clock::time_point deadline) const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait_until(lock, deadline,
    [this, after, generation] { return this->Stopped || this->HasNewest(after, generation); });
  if (this->Stopped || !this->HasNewest(after, generation))
  {
    return nullptr;
  }
  return this->Snapshots.back();
}

void lms3dSnapshotStore::Stop()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
  }
  this->Changed.notify_all();
}

bool lms3dSnapshotStore::IsStopped() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Stopped;
}
