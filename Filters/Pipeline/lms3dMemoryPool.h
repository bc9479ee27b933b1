// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory for outputs that is reused after all arrays have released it.
 *
 * The system takes longer to provide the pages of new memory than a scan takes. A block that a VTK
 * array owns returns to the pool when the last array that shares it is deleted, in any thread,
 * and the next scan uses it again. Blocks that are in use outlive the pool.
 */
#ifndef lms3dMemoryPool_h
#define lms3dMemoryPool_h

#include <cstddef>
#include <memory>

/// All methods may be called by any thread.
class lms3dMemoryPool
{
public:
  lms3dMemoryPool();
  ~lms3dMemoryPool();
  lms3dMemoryPool(const lms3dMemoryPool&) = delete;
  lms3dMemoryPool& operator=(const lms3dMemoryPool&) = delete;

  /// Returns a block of at least `bytes` bytes, not initialized, aligned to 64 bytes. The caller
  /// must return it. Throws std::runtime_error, with a text for the user, if memory is short.
  void* Take(std::size_t bytes);

  /// Returns a block to its pool, or frees it if the pool is deleted.
  static void Return(void* block);

  /// Frees all blocks that are not in use.
  void FreeUnused();

private:
  struct FreeBlocks;
  struct Header;
  std::shared_ptr<FreeBlocks> Blocks;
};

#endif
