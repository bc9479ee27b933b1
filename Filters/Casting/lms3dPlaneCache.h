// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Keeps the planes of recent triangles, because neighbouring packets hit the same ones.
 */
#ifndef lms3dPlaneCache_h
#define lms3dPlaneCache_h

#include "Kernels/lms3dBeamPacket.h"

#include <array>
#include <cstdint>
#include <new>
#include <type_traits>

template <typename Plane, int NumberOfEntries>
class lms3dPlaneCache
{
  static_assert(std::is_trivially_destructible_v<Plane>, "planes are overwritten");

public:
  lms3dPlaneCache() { this->Clear(); }

  void Clear() { this->Triangles.fill(lms3dBeamPacket::NoTriangle); }

  /// Returns the plane of a triangle. `make` computes it if it is not kept.
  template <typename Make>
  const Plane& Get(std::int32_t triangle, const Make& make)
  {
    const std::int32_t entry = triangle % NumberOfEntries;
    if (this->Triangles[entry] != triangle)
    {
      this->Triangles[entry] = triangle;
      // Made in place: `make` stores a plane in small pieces, and processors wait before they load
      // several of these at once to copy them.
      ::new (static_cast<void*>(&this->Planes[entry])) Plane(make(triangle));
    }
    return this->Planes[entry];
  }

  /// Returns the plane of a triangle if it is kept, otherwise null.
  const Plane* Find(std::int32_t triangle) const
  {
    const std::int32_t entry = triangle % NumberOfEntries;
    return this->Triangles[entry] == triangle ? &this->Planes[entry] : nullptr;
  }

  void Set(std::int32_t triangle, const Plane& plane)
  {
    const std::int32_t entry = triangle % NumberOfEntries;
    this->Triangles[entry] = triangle;
    this->Planes[entry] = plane;
  }

private:
  std::array<std::int32_t, NumberOfEntries> Triangles;
  std::array<Plane, NumberOfEntries> Planes;
};

#endif
