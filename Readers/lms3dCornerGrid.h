// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds points of the plane by where they are.
 */
#ifndef lms3dCornerGrid_h
#define lms3dCornerGrid_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Points by their numbers, in square cells over all of them. Keeps its memory for the next Build().
class lms3dCornerGrid
{
public:
  using Point = std::array<double, 2>;

  /// Has these of the points.
  void Build(const std::vector<Point>& points, const std::vector<std::int32_t>& chosen);

  void Remove(std::int32_t number, const Point& point);

  /// Whether a test holds for all points in the cells from the least to the most; stops at the first
  /// for which it does not. `work` counts cells and points down to 0.
  template <typename Test>
  bool AllOf(const Point& least, const Point& most, std::size_t& work, const Test& test) const
  {
    for (std::size_t y = this->GetColumn(least, 1); y <= this->GetColumn(most, 1); ++y)
    {
      for (std::size_t x = this->GetColumn(least, 0); x <= this->GetColumn(most, 0); ++x)
      {
        const std::size_t cell = y * this->Size + x;
        const auto begin = this->Numbers.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell]);
        const auto end = this->Numbers.begin() + static_cast<std::ptrdiff_t>(this->End[cell]);
        work -= std::min(work, 1 + this->End[cell] - this->Begin[cell]);
        if (!std::all_of(begin, end, test))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::size_t GetColumn(const Point& point, int axis) const;
  std::size_t GetCell(const Point& point) const;
  void Measure(const std::vector<Point>& points, std::size_t count);

  std::size_t Size = 1;
  Point Origin = {};
  Point CellsPerLength = {};
  std::vector<std::size_t> Begin;
  std::vector<std::size_t> End;
  std::vector<std::int32_t> Numbers;
};

#endif
