// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory for the blocks of the planes of a map.
 *
 * Most of what a scan changes lies in blocks that are far apart in memory. Therefore blocks lie in
 * huge pages, as far as the system has these: finding the page of an address takes longer than
 * the change itself.
 */
#ifndef lms3dBlockMemory_h
#define lms3dBlockMemory_h

#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

/// Pieces of memory of one size. Its memory returns to the system with the last owner. All methods
/// may be called by any thread.
class lms3dBlockMemory
{
public:
  /// Bytes, a multiple of the alignment: at most that of a cache line, 64.
  explicit lms3dBlockMemory(std::size_t size)
    : Size(size)
  {
  }

  std::size_t GetSize() const { return this->Size; }

  /// Returns a piece, not initialized. Throws std::bad_alloc if memory is short.
  void* Take();
  void Return(void* piece);

private:
  struct Free
  {
    void operator()(void* memory) const;
  };

  void AddPage();

  const std::size_t Size;
  std::mutex Mutex;
  std::vector<std::unique_ptr<void, Free>> Pages;
  /// Pieces that are not in use.
  std::vector<void*> Unused;
};

/// Gives single blocks of a container memory of a lms3dBlockMemory of their size. Without one, and
/// for several at once, the memory is that of std::allocator.
template <typename T>
class lms3dBlockAllocator
{
public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  explicit lms3dBlockAllocator(std::shared_ptr<lms3dBlockMemory> memory = nullptr)
    : Memory(std::move(memory))
  {
  }
  // Without moves, since a container that was moved from still has its allocator.
  lms3dBlockAllocator(const lms3dBlockAllocator& other) = default;
  lms3dBlockAllocator& operator=(const lms3dBlockAllocator& other) = default;
  ~lms3dBlockAllocator() = default;
  template <typename Other>
  explicit lms3dBlockAllocator(const lms3dBlockAllocator<Other>& other)
    : Memory(other.GetMemory())
  {
  }

  const std::shared_ptr<lms3dBlockMemory>& GetMemory() const { return this->Memory; }

  T* allocate(std::size_t count)
  {
    return this->IsPiece(count) ? static_cast<T*>(this->Memory->Take())
                                : std::allocator<T>().allocate(count);
  }

  void deallocate(T* values, std::size_t count)
  {
    if (this->IsPiece(count))
    {
      this->Memory->Return(static_cast<void*>(values));
    }
    else
    {
      std::allocator<T>().deallocate(values, count);
    }
  }

  template <typename Other>
  bool operator==(const lms3dBlockAllocator<Other>& other) const
  {
    return this->Memory == other.GetMemory();
  }
  template <typename Other>
  bool operator!=(const lms3dBlockAllocator<Other>& other) const
  {
    return !(*this == other);
  }

private:
  bool IsPiece(std::size_t count) const
  {
    return this->Memory && count == 1 && sizeof(T) == this->Memory->GetSize();
  }

  std::shared_ptr<lms3dBlockMemory> Memory;
};

#endif
