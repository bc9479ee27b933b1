// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The border of the surface at a vertex, from the sides of its star.
 */
#ifndef lms3dStarSides_h
#define lms3dStarSides_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The border at a vertex. The surface lies to the left of the way from Last over the vertex to
/// Next.
struct lms3dStarBorder
{
  std::int32_t Last = -1;
  std::int32_t Next = -1;

  bool IsOpen() const { return this->Next >= 0; }
  bool operator==(const lms3dStarBorder& other) const
  {
    return this->Last == other.Last && this->Next == other.Next;
  }
};

/// The sides of the triangles around a vertex that lie opposite the vertex. Each runs
/// counter-clockwise, as the sensor sees the triangle.
class lms3dStarSides
{
public:
  void Add(std::int32_t next, std::int32_t last)
  {
    if (this->Size < this->Usual.size())
    {
      this->Usual[this->Size] = { next, last };
    }
    else
    {
      this->AddToMany({ next, last });
    }
    ++this->Size;
    this->Difference ^= next ^ last;
  }

  /// Finds the border; inside of the surface, it is not open. Returns false if the sides do not
  /// follow each other around the vertex, once.
  bool FindBorder(lms3dStarBorder& border) const;

  /// Whether a vertex is the start or the end of a side.
  bool Has(std::int32_t vertex) const;

  /// The number of vertices that both stars have.
  int CountCommon(const lms3dStarSides& other) const;

private:
  struct Side
  {
    std::int32_t Next;
    std::int32_t Last;
  };

  void AddToMany(const Side& side);
  const Side* GetSides() const
  {
    return this->Size > this->Usual.size() ? this->Many.data() : this->Usual.data();
  }
  std::int32_t FindLast(std::int32_t next) const;
  bool IsClosed() const;
  bool IsLast(std::int32_t vertex) const;

  std::size_t Size = 0;
  /// All starts and ends of sides by exclusive or: 0 if each start is an end.
  std::int32_t Difference = 0;
  /// The sides, unless there are more. Most stars have six.
  std::array<Side, 32> Usual;
  std::vector<Side> Many;
};

#endif
