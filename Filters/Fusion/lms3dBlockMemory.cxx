// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dBlockMemory.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace
{
// Bytes: the large pages of most processors.
constexpr std::size_t PageSize = std::size_t{ 1 } << 21U;
} // namespace

void lms3dBlockMemory::Free::operator()(void* memory) const
{
  ::operator delete(memory, std::align_val_t(PageSize));
}

void* lms3dBlockMemory::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Unused.empty())
  {
    this->AddPage();
  }
  void* const piece = this->Unused.back();
  this->Unused.pop_back();
  return piece;
}

void lms3dBlockMemory::Return(void* piece)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Unused.push_back(piece);
}

// Pieces are taken in order of their addresses. Return() never needs more memory than this.
void lms3dBlockMemory::AddPage()
{
  const std::size_t count = PageSize / this->Size;
  this->Unused.reserve((this->Pages.size() + 1) * count);
  this->Pages.reserve(this->Pages.size() + 1);
  this->Pages.emplace_back(::operator new(PageSize, std::align_val_t(PageSize)));
  auto* const page = static_cast<std::uint8_t*>(this->Pages.back().get());
#ifdef __linux__
  // If there are no large pages, small ones serve.
  static_cast<void>(madvise(page, PageSize, MADV_HUGEPAGE));
#endif
  for (std::size_t i = count; i > 0; --i)
  {
    this->Unused.push_back(page + (i - 1) * this->Size);
  }
}
