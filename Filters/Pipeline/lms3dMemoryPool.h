// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory for outputs that is used again once nobody looks at it any more.
 *
 * New memory costs the system more than a scan takes, page by page. A block that is handed to a VTK
 * array comes back when the last of all arrays that share it lets go of it, wherever that happens,
 * and serves the next scan. The blocks outlive the pool where they must.
 */
#ifndef lms3dMemoryPool_h
#define lms3dMemoryPool_h

#include <cstddef>
#include <memory>

class lms3dMemoryPool
{
public:
  lms3dMemoryPool();
  ~lms3dMemoryPool();
  lms3dMemoryPool(const lms3dMemoryPool&) = delete;
  lms3dMemoryPool& operator=(const lms3dMemoryPool&) = delete;

  /// A block of at least so many bytes, not cleared; throws std::runtime_error where there is none.
  void* Take(std::size_t bytes);

  /// Gives a block back; may be called by any thread, also after the pool is gone.
  static void Return(void* block);

  /// Frees the blocks that came back and were not taken again.
  void FreeUnused();

private:
  struct Shelf;
  struct Header;
  std::shared_ptr<Shelf> Blocks;
};

#endif
