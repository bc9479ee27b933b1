// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the number of a place on a grid of any extent.
 */
#ifndef lms3dBlockIndex_h
#define lms3dBlockIndex_h

#include <cstddef>
#include <cstdint>
#include <vector>

/// A hash table with open addresses, at most half full.
class lms3dBlockIndex
{
public:
  /// The number of a place, -1 if it has none.
  int Find(std::int32_t u, std::int32_t v) const
  {
    return this->Slots.empty() ? -1 : this->Slots[this->FindSlot(u, v)].Number;
  }

  /// Gives a number of at least 0 to a place without one.
  void Add(std::int32_t u, std::int32_t v, int number)
  {
    if (2 * (this->Count + 1) > this->Slots.size())
    {
      this->Grow();
    }
    this->Slots[this->FindSlot(u, v)] = { u, v, number };
    ++this->Count;
  }

private:
  struct Slot
  {
    std::int32_t U = 0;
    std::int32_t V = 0;
    int Number = -1;
  };

  std::size_t FindSlot(std::int32_t u, std::int32_t v) const
  {
    const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(u)) << 32 |
      static_cast<std::uint32_t>(v);
    // Fibonacci hashing: the golden ratio as a share of 2^64.
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 32) & mask;
    while (this->Slots[slot].Number >= 0 && (this->Slots[slot].U != u || this->Slots[slot].V != v))
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void Grow()
  {
    std::vector<Slot> old(this->Slots.empty() ? 4 : 2 * this->Slots.size());
    old.swap(this->Slots);
    for (const Slot& slot : old)
    {
      if (slot.Number >= 0)
      {
        this->Slots[this->FindSlot(slot.U, slot.V)] = slot;
      }
    }
  }

  /// A power of 2.
  std::vector<Slot> Slots;
  std::size_t Count = 0;
};

#endif
