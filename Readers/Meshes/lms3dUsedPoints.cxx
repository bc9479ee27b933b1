// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dUsedPoints.h"

#include <algorithm>

namespace
{
using Triangle = std::array<std::int32_t, 3>;

lms3dPoint GetPoint(const std::vector<double>& coordinates, std::size_t index)
{
  const double* point = coordinates.data() + 3 * index;
  return { point[0], point[1], point[2] };
}

template <typename GetNewIndex>
void Renumber(lms3dMesh& mesh, const GetNewIndex& getNewIndex)
{
  for (Triangle& triangle : mesh.Triangles)
  {
    std::transform(triangle.begin(), triangle.end(), triangle.begin(), getNewIndex);
  }
}

void CopyByTable(const std::vector<double>& coordinates, lms3dMesh& mesh)
{
  const std::size_t count = coordinates.size() / 3;
  std::vector<std::int32_t> newIndices(count, -1);
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (std::int32_t index : triangle)
    {
      newIndices[static_cast<std::size_t>(index)] = 0;
    }
  }
  mesh.Points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (newIndices[i] == 0)
    {
      newIndices[i] = static_cast<std::int32_t>(mesh.Points.size());
      mesh.Points.push_back(GetPoint(coordinates, i));
    }
  }
  Renumber(mesh,
    [&newIndices](std::int32_t index) { return newIndices[static_cast<std::size_t>(index)]; });
}

// The time does not depend on the number of points in the list.
void CopyBySorting(const std::vector<double>& coordinates, lms3dMesh& mesh)
{
  std::vector<std::int32_t> used;
  for (const Triangle& triangle : mesh.Triangles)
  {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::int32_t index : used)
  {
    mesh.Points.push_back(GetPoint(coordinates, static_cast<std::size_t>(index)));
  }
  Renumber(mesh,
    [&used](std::int32_t index)
    {
      return static_cast<std::int32_t>(
        std::lower_bound(used.begin(), used.end(), index) - used.begin());
    });
}
} // namespace

void lms3dCopyUsedPoints(const std::vector<double>& coordinates, lms3dMesh& mesh)
{
  const bool areFew = 4 * mesh.Triangles.size() < coordinates.size() / 3;
  (areFew ? CopyBySorting : CopyByTable)(coordinates, mesh);
}
