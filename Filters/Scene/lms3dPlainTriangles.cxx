// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dPlainTriangles.h"

#include <vtkCellArray.h>
#include <vtkType.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace
{
constexpr std::size_t MaximumNumberOfTriangles = std::numeric_limits<std::int32_t>::max();

// Enough for the preparations of a task to cost little.
constexpr vtkIdType TrianglesOfTask = 8192;

/// Cells with their points in an array of either type that vtkCellArray has.
template <typename Id>
struct Cells
{
  bool AreTriangles(const tbb::blocked_range<vtkIdType>& range) const
  {
    bool areTriangles = true;
    for (vtkIdType i = range.begin(); i < range.end(); ++i)
    {
      areTriangles &= this->Offsets[i + 1] - this->Offsets[i] == 3;
    }
    return areTriangles;
  }

  // Returns false if the triangle uses a point that is missing or not usable.
  bool Copy(vtkIdType cell, std::array<std::uint32_t, 3>& triangle) const
  {
    const Id* corners = this->Corners + this->Offsets[cell];
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
  std::atomic<bool> arePlain{ cells.Offsets[0] == 0 };
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
} // namespace

bool lms3dAppendPlainTriangles(vtkCellArray* cells, std::size_t firstPoint, lms3dTriangleMesh& mesh)
{
  const vtkIdType count = cells->GetNumberOfCells();
  const std::size_t before = mesh.Triangles.size();
  if (before + static_cast<std::size_t>(count) > MaximumNumberOfTriangles ||
    cells->GetNumberOfConnectivityIds() != 3 * count)
  {
    return false;
  }
  mesh.Triangles.resize(before + static_cast<std::size_t>(count));
  const auto copy = [&](auto* offsets, auto* corners)
  {
    using Id = std::remove_reference_t<decltype(*offsets->GetPointer(0))>;
    const Cells<Id> all = { offsets->GetPointer(0), corners->GetPointer(0), mesh.Points,
      firstPoint };
    return CopyAll(all, count, mesh.Triangles.data() + before);
  };
  const bool arePlain = cells->IsStorage64Bit()
    ? copy(cells->GetOffsetsArray64(), cells->GetConnectivityArray64())
    : copy(cells->GetOffsetsArray32(), cells->GetConnectivityArray32());
  if (!arePlain)
  {
    mesh.Triangles.resize(before);
  }
  return arePlain;
}
