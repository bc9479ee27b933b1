// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dMemoryPool.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

/// Precedes the bytes of a block.
struct alignas(64) lms3dMemoryPool::Header
{
  std::shared_ptr<FreeBlocks> Owner;
  std::size_t Bytes;
};

/// The blocks that are not in use.
struct lms3dMemoryPool::FreeBlocks
{
  std::mutex Lock;
  std::vector<Header*> Unused;
  bool IsOpen = true;

  static void Free(Header* block)
  {
    block->~Header();
    std::free(block);
  }

  // Returns the smallest block that is large enough, but at most twice as large as needed; else
  // null.
  Header* Find(std::size_t bytes)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    auto best = this->Unused.end();
    for (auto it = this->Unused.begin(); it != this->Unused.end(); ++it)
    {
      const bool fits = (*it)->Bytes >= bytes && (*it)->Bytes <= 2 * bytes;
      best = fits && (best == this->Unused.end() || (*it)->Bytes < (*best)->Bytes) ? it : best;
    }
    if (best == this->Unused.end())
    {
      return nullptr;
    }
    Header* block = *best;
    this->Unused.erase(best);
    return block;
  }

  std::vector<Header*> TakeAll()
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    std::vector<Header*> all;
    all.swap(this->Unused);
    return all;
  }

  bool Keep(Header* block)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    if (this->IsOpen)
    {
      this->Unused.push_back(block);
    }
    return this->IsOpen;
  }
};

lms3dMemoryPool::lms3dMemoryPool()
  : Blocks(std::make_shared<FreeBlocks>())
{
}

lms3dMemoryPool::~lms3dMemoryPool()
{
  {
    const std::lock_guard<std::mutex> guard(this->Blocks->Lock);
    this->Blocks->IsOpen = false;
  }
  this->FreeUnused();
}

void* lms3dMemoryPool::Take(std::size_t bytes)
{
  Header* block = this->Blocks->Find(bytes);
  if (!block)
  {
    const std::size_t whole = (sizeof(Header) + bytes + 63) / 64 * 64;
    void* memory = std::aligned_alloc(64, whole);
    if (!memory)
    {
      throw std::runtime_error("There is not enough memory for " + std::to_string(bytes >> 20) +
        " MiB of a scan. Choose lower resolutions.");
    }
    block = new (memory) Header{ this->Blocks, whole - sizeof(Header) };
  }
  return block + 1;
}

void lms3dMemoryPool::Return(void* block)
{
  Header* header = static_cast<Header*>(block) - 1;
  // Keeps the free blocks' list alive during the call, since the block can have the last reference.
  const std::shared_ptr<FreeBlocks> owner = header->Owner;
  if (!owner->Keep(header))
  {
    FreeBlocks::Free(header);
  }
}

void lms3dMemoryPool::FreeUnused()
{
  for (Header* block : this->Blocks->TakeAll())
  {
    FreeBlocks::Free(block);
  }
}
