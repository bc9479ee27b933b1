// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A uniform grid of points in the plane.
 */
#ifndef lms3dCornerGrid_h
#define lms3dCornerGrid_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Finds the points near a rectangle. The grid has about two points in each cell, and 1,024 x 1,024
 * cells at most. It stores the indices of points, not their coordinates. It reuses its memory for
 * the next Build().
 */
class lms3dCornerGrid
{
public:
  using Point = std::array<double, 2>;

  /// Inserts the points with the indices `chosen`. The cells cover the bounds of all points.
  void Build(const std::vector<Point>& points, const std::vector<std::int32_t>& chosen);

  /// Removes an index, if it is in the grid. `point` must be the same as in Build(). Returns the
  /// work: the number of indices in the cell.
  std::size_t Remove(std::int32_t index, const Point& point);

  /// Returns whether a test holds for all indices in the cells that the rectangle touches. Stops at
  /// the first one for which the test fails. Increases `work` by one for each visited cell and each
  /// index in it.
  template <typename Test>
  bool AllOf(const Point& minimum, const Point& maximum, std::size_t& work, const Test& test) const
  {
    for (std::size_t y = this->GetColumn(minimum, 1); y <= this->GetColumn(maximum, 1); ++y)
    {
      for (std::size_t x = this->GetColumn(minimum, 0); x <= this->GetColumn(maximum, 0); ++x)
      {
        const std::size_t cell = y * this->Size + x;
        const auto begin = this->Indices.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell]);
        const auto end = this->Indices.begin() + static_cast<std::ptrdiff_t>(this->End[cell]);
        work += 1 + this->End[cell] - this->Begin[cell];
        if (!std::all_of(begin, end, test))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  /// Returns the column (axis 0) or row (axis 1) of a point, clamped to the grid.
  std::size_t GetColumn(const Point& point, int axis) const;
  std::size_t GetCell(const Point& point) const;
  /// Chooses the number of cells for `count` points, and their size.
  void SetUpCells(const std::vector<Point>& points, std::size_t count);

  /// The number of columns and of rows.
  std::size_t Size = 1;
  Point Origin = {};
  Point CellsPerLength = {};
  ///@{
  /// The range of each cell in Indices.
  std::vector<std::size_t> Begin;
  std::vector<std::size_t> End;
  ///@}
  std::vector<std::int32_t> Indices;
};

#endif
