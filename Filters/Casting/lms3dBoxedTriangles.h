// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles in each box of Embree's tree.
 *
 * The two halves of a square are often successive triangles, and their boxes are nearly the same: a
 * beam that meets one box meets the other. One box for both makes the tree half as large and
 * quicker to build.
 */
#ifndef lms3dBoxedTriangles_h
#define lms3dBoxedTriangles_h

#include "Casting/lms3dNormalization.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dBoxedTriangles
{
public:
  /// Successive triangles.
  struct Range
  {
    std::uint32_t First;
    std::uint32_t Count;
  };

  /// Leaves out the `excluded` triangles, which are in increasing order, like the normalization.
  /// Mesh and normalization must outlive this object.
  lms3dBoxedTriangles(const lms3dTriangleMesh& mesh, const lms3dNormalization& normalization,
    const std::vector<std::uint32_t>& excluded);

  std::size_t GetCount() const { return this->Count; }

  /// Returns the triangles of a box.
  Range Get(std::uint32_t box) const
  {
    return this->Ranges.empty() ? Range{ box, 1 }
                                : Range{ this->Ranges[box] >> 1, 1 + (this->Ranges[box] & 1u) };
  }

  lms3dNormalizedBox GetBox(std::uint32_t box) const;

private:
  void AddPairs();
  lms3dNormalizedBox GetBoxOfTriangle(std::uint32_t triangle) const
  {
    return this->Normalization.GetBox(lms3dGetCorners(this->Mesh, triangle));
  }

  const lms3dTriangleMesh& Mesh;
  const lms3dNormalization& Normalization;

  /// Twice the first triangle of each box, plus one for a pair. Empty if box i has triangle i
  /// alone.
  std::vector<std::uint32_t> Ranges;
  std::size_t Count;
};

#endif
