// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles of a scene as ray casters take them: shared points and indices.
 */
#ifndef lms3dTriangleMesh_h
#define lms3dTriangleMesh_h

#include "Geometry/lms3dHugePages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

///@{
/// The points of a mesh, and three indices into them for each triangle.
using lms3dTrianglePoints =
  std::vector<std::array<double, 3>, lms3dHugePageAllocator<std::array<double, 3>>>;
using lms3dTriangleIndices =
  std::vector<std::array<std::uint32_t, 3>, lms3dHugePageAllocator<std::array<std::uint32_t, 3>>>;
///@}

struct lms3dTriangleMesh
{
  /// Vertices in world coordinates, metres. Vertices that triangles use are finite.
  lms3dTrianglePoints Points;

  lms3dTriangleIndices Triangles;

  /// For each triangle the index of the scene's cell that it is a part of. Empty if triangle i is a
  /// part of cell i.
  std::vector<std::int64_t> Cells;

  /// Lists the cells of all triangles even if triangle i is a part of cell i.
  void ListCells()
  {
    this->Cells.reserve(this->Triangles.capacity());
    for (std::size_t i = this->Cells.size(); i < this->Triangles.size(); ++i)
    {
      this->Cells.push_back(static_cast<std::int64_t>(i));
    }
  }

  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }

  std::int64_t GetCell(std::size_t triangle) const
  {
    return this->Cells.empty() ? static_cast<std::int64_t>(triangle) : this->Cells[triangle];
  }

  const double* GetCorner(std::size_t triangle, int corner) const
  {
    return this->Points[this->Triangles[triangle][corner]].data();
  }
};

/// The three corners of a triangle in world coordinates, metres. Points into the mesh.
using lms3dCorners = std::array<const double*, 3>;

inline lms3dCorners lms3dGetCorners(const lms3dTriangleMesh& mesh, std::size_t triangle)
{
  return { mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1), mesh.GetCorner(triangle, 2) };
}

#endif
