// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Cells/lms3dBlockMemory.h"

#include "Geometry/lms3dHugePages.h"

#include <cstdint>

void lms3dBlockMemory::Free::operator()(void* memory) const
{
  ::operator delete(memory, std::align_val_t(lms3dHugePageSize));
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
  const std::size_t count = lms3dHugePageSize / this->Size;
  this->Unused.reserve((this->Pages.size() + 1) * count);
  this->Pages.reserve(this->Pages.size() + 1);
  this->Pages.emplace_back(::operator new(lms3dHugePageSize, std::align_val_t(lms3dHugePageSize)));
  auto* const page = static_cast<std::uint8_t*>(this->Pages.back().get());
  lms3dRequestHugePages(page, lms3dHugePageSize);
  for (std::size_t i = count; i > 0; --i)
  {
    this->Unused.push_back(page + (i - 1) * this->Size);
  }
}
