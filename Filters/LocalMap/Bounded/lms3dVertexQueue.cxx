// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexQueue.h"

#include <algorithm>
#include <cstddef>

lms3dVertexQueue::lms3dVertexQueue(const lms3dVertexStars& stars)
  : Stars(stars)
  , Marks(stars.GetNumberOfVertices(), 0)
{
}

void lms3dVertexQueue::Update(const std::vector<std::int32_t>& removed, std::vector<Entry> added)
{
  ++this->Call;
  for (std::int32_t vertex : removed)
  {
    this->Marks[vertex] = this->Call;
  }
  const auto isRemoved = [this](const Entry& entry)
  { return this->Marks[entry.Vertex] == this->Call; };
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(), isRemoved), this->Entries.end());
  std::sort(added.begin(), added.end());
  const auto kept = static_cast<std::ptrdiff_t>(this->Entries.size());
  this->Entries.insert(this->Entries.end(), added.begin(), added.end());
  std::inplace_merge(this->Entries.begin(), this->Entries.begin() + kept, this->Entries.end());
}

std::vector<std::int32_t> lms3dVertexQueue::TakeIndependent()
{
  ++this->Call;
  std::vector<std::int32_t> taken;
  std::size_t kept = 0;
  for (const Entry& entry : this->Entries)
  {
    if (this->TryToUse(entry.Vertex))
    {
      taken.push_back(entry.Vertex);
    }
    else
    {
      this->Entries[kept++] = entry;
    }
  }
  this->Entries.resize(kept);
  return taken;
}

// Marks the star of a vertex. Returns false, and marks nothing, if a part of it is marked already.
bool lms3dVertexQueue::TryToUse(std::int32_t vertex)
{
  const auto isFree = [this](std::int32_t number) { return this->Marks[number] != this->Call; };
  if (!isFree(vertex) ||
    !this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      { return isFree(next) && isFree(last); }))
  {
    return false;
  }
  this->Marks[vertex] = this->Call;
  this->Stars.ForEachTriangle(vertex,
    [this](std::int32_t, std::int32_t next, std::int32_t last)
    {
      this->Marks[next] = this->Call;
      this->Marks[last] = this->Call;
      return true;
    });
  return true;
}
