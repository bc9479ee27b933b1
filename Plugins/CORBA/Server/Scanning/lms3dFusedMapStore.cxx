// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dFusedMapStore.h"

#include <algorithm>
#include <utility>
#include <vector>

lms3dFusedMapStore::lms3dFusedMapStore(std::size_t keep, std::size_t maximumBytes)
  : Keep(keep)
  , MaximumBytes(maximumBytes)
{
}

void lms3dFusedMapStore::Publish(lms3dFusedMapPointer state)
{
  // Declared before the lock, so that the memory is freed after unlocking.
  std::vector<lms3dFusedMapPointer> displaced;
  const std::size_t bytes = state->GetBytes();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Bytes += bytes;
  this->States.push_back(std::move(state));
  while (this->IsOverLimit())
  {
    this->Bytes -= this->States.front()->GetBytes();
    displaced.push_back(std::move(this->States.front()));
    this->States.pop_front();
  }
}

bool lms3dFusedMapStore::IsOverLimit() const
{
  const std::size_t number = this->States.size();
  return number > this->Keep || (number > 1 && this->Bytes > this->MaximumBytes);
}

lms3dFusedMapPointer lms3dFusedMapStore::GetNewest() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->States.empty() ? nullptr : this->States.back();
}

lms3dFusedMapPointer lms3dFusedMapStore::Find(std::uint64_t number) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto state = std::find_if(this->States.begin(), this->States.end(),
    [number](const lms3dFusedMapPointer& kept) { return kept->Header.number == number; });
  return state == this->States.end() ? nullptr : *state;
}

std::uint64_t lms3dFusedMapStore::GetOldestNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->States.empty() ? 0 : this->States.front()->Header.number;
}

std::uint64_t lms3dFusedMapStore::GetNewestNumber() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->States.empty() ? 0 : this->States.back()->Header.number;
}

void lms3dFusedMapStore::SetProblem(const std::string& problem)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Problem = problem;
}

std::string lms3dFusedMapStore::GetProblem() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Problem;
}
