// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dPlainTriangles.h"

#include <vtkCellArray.h>
#include <vtkType.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace
{
constexpr std::size_t MaximumNumberOfTriangles = std::numeric_limits<std::int32_t>::max();

// Enough for the preparations of a task to cost little.
constexpr vtkIdType TrianglesOfTask = 8192;

/// Cells with their points in an array of either type that vtkCellArray has.
template <typename Id>
struct Cells
{
  // Returns whether the cells are triangles, which begin where those before them end.
  bool AreTriangles(const tbb::blocked_range<vtkIdType>& range) const
  {
    bool areTriangles = true;
    for (vtkIdType i = range.begin(); i <= range.end(); ++i)
    {
      areTriangles &= static_cast<vtkIdType>(this->Offsets[i]) == 3 * i;
    }
    return areTriangles;
  }

  // Returns false if the triangle uses a point that is missing or not usable.
  bool Copy(vtkIdType cell, std::array<std::uint32_t, 3>& triangle) const
  {
    const Id* corners = this->Corners + 3 * cell;
    for (int i = 0; i < 3; ++i)
    {
      const std::size_t point = this->FirstPoint + static_cast<std::size_t>(corners[i]);
      if (corners[i] < 0 || point >= this->Points.size() || !lms3dIsUsable(this->Points[point]))
      {
        return false;
      }
      triangle[i] = static_cast<std::uint32_t>(point);
    }
    return true;
  }

  const Id* Offsets;
  const Id* Corners;
  const lms3dTrianglePoints& Points;
  std::size_t FirstPoint;
};

template <typename Id>
bool CopyAll(const Cells<Id>& cells, vtkIdType count, std::array<std::uint32_t, 3>* triangles)
{
  std::atomic<bool> arePlain{ true };
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, TrianglesOfTask),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      bool isCopied = arePlain && cells.AreTriangles(range);
      for (vtkIdType i = range.begin(); isCopied && i < range.end(); ++i)
      {
        isCopied = cells.Copy(i, triangles[i]);
      }
      if (!isCopied)
      {
        arePlain = false;
      }
    });
  return arePlain;
}

// Appends the cells if they are stored in arrays of this type.
template <typename Array>
bool AppendStored(vtkCellArray* cells, std::size_t firstPoint, lms3dTriangleMesh& mesh)
{
  Array* offsets = Array::FastDownCast(cells->GetOffsetsArray());
  Array* corners = Array::FastDownCast(cells->GetConnectivityArray());
  if (!offsets || !corners)
  {
    return false;
  }
  const vtkIdType count = cells->GetNumberOfCells();
  const std::size_t before = mesh.Triangles.size();
  mesh.Triangles.resize(before + static_cast<std::size_t>(count));
  const Cells<typename Array::ValueType> stored = { offsets->GetPointer(0), corners->GetPointer(0),
    mesh.Points, firstPoint };
  const bool arePlain = CopyAll(stored, count, mesh.Triangles.data() + before);
  if (!arePlain)
  {
    mesh.Triangles.resize(before);
  }
  return arePlain;
}
} // namespace

bool lms3dAppendPlainTriangles(vtkCellArray* cells, std::size_t firstPoint, lms3dTriangleMesh& mesh)
{
  const vtkIdType count = cells->GetNumberOfCells();
  if (mesh.Triangles.size() + static_cast<std::size_t>(count) > MaximumNumberOfTriangles ||
    cells->GetNumberOfConnectivityIds() != 3 * count)
  {
    return false;
  }
  return AppendStored<vtkTypeInt64Array>(cells, firstPoint, mesh) ||
    AppendStored<vtkTypeInt32Array>(cells, firstPoint, mesh);
}
