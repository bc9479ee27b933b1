// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/lms3dCornerGrid.h"

#include <cmath>
#include <numeric>

namespace
{
constexpr std::size_t MaximumSize = 1024;
}

std::size_t lms3dCornerGrid::GetColumn(const Point& point, int axis) const
{
  const double column = (point[axis] - this->Origin[axis]) * this->CellsPerLength[axis];
  return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(this->Size - 1)));
}

std::size_t lms3dCornerGrid::GetCell(const Point& point) const
{
  return this->GetColumn(point, 1) * this->Size + this->GetColumn(point, 0);
}

// Chooses about two points in each cell.
void lms3dCornerGrid::SetUpCells(const std::vector<Point>& points, std::size_t count)
{
  this->Size = std::clamp<std::size_t>(
    static_cast<std::size_t>(std::sqrt(0.5 * static_cast<double>(count))), 1, MaximumSize);
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto [minimum, maximum] = std::minmax_element(points.begin(), points.end(),
      [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    const double cells = static_cast<double>(this->Size) / ((*maximum)[axis] - (*minimum)[axis]);
    this->Origin[axis] = (*minimum)[axis];
    this->CellsPerLength[axis] = std::isfinite(cells) ? cells : 0.0;
  }
}

void lms3dCornerGrid::Build(
  const std::vector<Point>& points, const std::vector<std::int32_t>& chosen)
{
  this->SetUpCells(points, chosen.size());
  this->End.assign(this->Size * this->Size, 0);
  for (std::int32_t index : chosen)
  {
    ++this->End[this->GetCell(points[index])];
  }
  this->Begin.resize(this->End.size());
  std::exclusive_scan(this->End.begin(), this->End.end(), this->Begin.begin(), std::size_t(0));
  this->End = this->Begin;
  this->Indices.resize(chosen.size());
  for (std::int32_t index : chosen)
  {
    this->Indices[this->End[this->GetCell(points[index])]++] = index;
  }
}

std::size_t lms3dCornerGrid::Remove(std::int32_t index, const Point& point)
{
  const std::size_t cell = this->GetCell(point);
  const std::size_t work = this->End[cell] - this->Begin[cell];
  const auto begin = this->Indices.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell]);
  const auto end = this->Indices.begin() + static_cast<std::ptrdiff_t>(this->End[cell]);
  const auto found = std::find(begin, end, index);
  if (found != end)
  {
    *found = end[-1];
    --this->End[cell];
  }
  return work;
}
