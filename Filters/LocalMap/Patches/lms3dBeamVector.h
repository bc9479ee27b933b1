// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vector with an entry for each beam of a scan.
 *
 * The C library returns memory of this size to the system, and gets it again for the next map, page
 * by page. That would take a tenth of the time of a map. TBB's allocator keeps the memory.
 */
#ifndef lms3dBeamVector_h
#define lms3dBeamVector_h

#include <tbb/tbb_allocator.h>

#include <new>
#include <utility>
#include <vector>

/// Leaves new entries without a value unless they get one, so that no thread has to fill them
/// twice.
template <typename T>
class lms3dBeamAllocator : public tbb::tbb_allocator<T>
{
public:
  lms3dBeamAllocator() = default;
  template <typename U>
  explicit lms3dBeamAllocator(const lms3dBeamAllocator<U>& /*other*/)
  {
  }

  template <typename U>
  struct rebind
  {
    using other = lms3dBeamAllocator<U>;
  };

  template <typename U>
  void construct(U* at)
  {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Values>
  void construct(U* at, Values&&... values)
  {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
};

/// Entries that are made without a value, by resize() or from a number, are not initialized.
template <typename T>
using lms3dBeamVector = std::vector<T, lms3dBeamAllocator<T>>;

#endif
