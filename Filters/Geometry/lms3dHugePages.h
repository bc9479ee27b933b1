// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An allocator that requests huge pages on Linux.
 *
 * Beams read the corners of a large mesh in an irregular order. With pages of 4 KiB most of these
 * reads also miss the processor's cache of page addresses. Pages of 2 MiB avoid that. On other
 * systems, and for small vectors, the allocator is the usual one.
 */
#ifndef lms3dHugePages_h
#define lms3dHugePages_h

#include <cstddef>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

/// Bytes.
inline constexpr std::size_t lms3dHugePageSize = std::size_t(1) << 21;

/// Requests huge pages for memory at a multiple of their size. The system may refuse, and then
/// gives pages of the usual size.
inline void lms3dRequestHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size)
{
#ifdef __linux__
  static_cast<void>(madvise(memory, size, MADV_HUGEPAGE));
#endif
}

template <typename T>
struct lms3dHugePageAllocator
{
  using value_type = T;

  /// Bytes. Smaller vectors would gain nothing.
  static constexpr std::size_t MinimumSize = 2 * lms3dHugePageSize;

  static_assert(alignof(T) <= alignof(std::max_align_t), "small vectors have the usual alignment");

  lms3dHugePageAllocator() = default;

  template <typename Other>
  explicit lms3dHugePageAllocator(const lms3dHugePageAllocator<Other>&)
  {
  }

  T* allocate(std::size_t count)
  {
    const std::size_t size = count * sizeof(T);
    T* memory = static_cast<T*>(::operator new(size, GetAlignment(count)));
    if (size >= MinimumSize)
    {
      lms3dRequestHugePages(memory, size);
    }
    return memory;
  }

  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, GetAlignment(count)); }

  static std::align_val_t GetAlignment(std::size_t count)
  {
    return std::align_val_t(
      count * sizeof(T) >= MinimumSize ? lms3dHugePageSize : alignof(std::max_align_t));
  }
};

template <typename T, typename Other>
bool operator==(const lms3dHugePageAllocator<T>&, const lms3dHugePageAllocator<Other>&)
{
  return true;
}

template <typename T, typename Other>
bool operator!=(const lms3dHugePageAllocator<T>&, const lms3dHugePageAllocator<Other>&)
{
  return false;
}

#endif
