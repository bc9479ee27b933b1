// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dRegionCover.h"

#include "Fusion/Cells/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace
{
/// The smaller end first.
using Edge = std::array<lms3dPoint2, 2>;

/// The edges of one triangle.
std::vector<Edge> FindBorder(const std::vector<lms3dTriangle2>& triangles)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const lms3dTriangle2& triangle : triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto [first, second] = std::minmax(triangle[corner], triangle[(corner + 1) % 3]);
      edges.push_back({ first, second });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> border;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if ((i == 0 || edges[i] != edges[i - 1]) && (i + 1 == edges.size() || edges[i] != edges[i + 1]))
    {
      border.push_back(edges[i]);
    }
  }
  return border;
}

/// Where the border crosses the middle of a row.
struct Crossing
{
  std::int32_t Row;
  double Place;
  bool operator<(const Crossing& other) const
  {
    return this->Row != other.Row ? this->Row < other.Row : this->Place < other.Place;
  }
};

/// Divides crossings by their rows first, which are few, and sorts each row.
void SortByRow(std::vector<Crossing>& crossings)
{
  if (crossings.empty())
  {
    return;
  }
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end(),
    [](const Crossing& a, const Crossing& b) { return a.Row < b.Row; });
  const std::int32_t first = low->Row;
  std::vector<std::size_t> ends(static_cast<std::size_t>(high->Row - first) + 2);
  for (const Crossing& crossing : crossings)
  {
    ++ends[static_cast<std::size_t>(crossing.Row - first) + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::size_t> places(ends.begin(), ends.end() - 1);
  std::vector<Crossing> sorted(crossings.size());
  for (const Crossing& crossing : crossings)
  {
    sorted[places[static_cast<std::size_t>(crossing.Row - first)]++] = crossing;
  }
  for (std::size_t row = 0; row + 1 < ends.size(); ++row)
  {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(ends[row]),
      sorted.begin() + static_cast<std::ptrdiff_t>(ends[row + 1]));
  }
  crossings.swap(sorted);
}

/// Each edge has its lower end, but not its upper one, so that each row has an even number of
/// crossings.
std::vector<Crossing> FindCrossings(const std::vector<Edge>& border)
{
  std::vector<Crossing> crossings;
  for (const Edge& edge : border)
  {
    const bool isUp = edge[0][1] <= edge[1][1];
    const lms3dPoint2& a = edge[isUp ? 0 : 1];
    const lms3dPoint2& b = edge[isUp ? 1 : 0];
    for (auto row = lms3dGetCellFrom(a[1] - 0.5); row + 0.5 < b[1]; ++row)
    {
      crossings.push_back({ row, a[0] + (b[0] - a[0]) * ((row + 0.5 - a[1]) / (b[1] - a[1])) });
    }
  }
  SortByRow(crossings);
  return crossings;
}

/// Sets Covered between successive crossings. The n-th spans of the rows of a row of blocks make a
/// strip.
class Filler
{
public:
  explicit Filler(lms3dRegion& raster)
    : Raster(raster)
  {
  }

  void Fill(const std::vector<Crossing>& crossings)
  {
    std::size_t span = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      const std::int32_t row = crossings[i].Row;
      const bool isNewRow = i == 0 || row != crossings[i - 1].Row;
      if (isNewRow &&
        (i == 0 || lms3dRaster::GetBlockOf(row) != lms3dRaster::GetBlockOf(crossings[i - 1].Row)))
      {
        this->Flush();
      }
      span = isNewRow ? 0 : span + 1;
      this->Add(span, row, lms3dGetCellFrom(crossings[i].Place - 0.5),
        lms3dGetCellOf(crossings[i + 1].Place - 0.5));
    }
    this->Flush();
  }

private:
  void Add(std::size_t span, std::int32_t row, std::int32_t first, std::int32_t last)
  {
    if (span == this->Strips.size())
    {
      this->Strips.emplace_back();
    }
    lms3dCellStrip& strip = this->Strips[span];
    if (strip.Count == 0)
    {
      strip.Row = row;
    }
    while (strip.Row + strip.Count < row)
    {
      strip.AddEmpty();
    }
    strip.Add(first, last);
  }

  void Flush()
  {
    for (const lms3dCellStrip& strip : this->Strips)
    {
      this->Raster.Set(&lms3dRasterBlock::Covered, strip, true);
    }
    this->Strips.clear();
  }

  lms3dRegion& Raster;
  std::vector<lms3dCellStrip> Strips;
};
} // namespace

void lms3dCoverRegion(const std::vector<lms3dTriangle2>& triangles, lms3dRegion& raster)
{
  const std::vector<Edge> border = FindBorder(triangles);
  Filler(raster).Fill(FindCrossings(border));
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    raster.GetBlock(i).Touched = raster.GetBlock(i).Covered;
  }
  for (const Edge& edge : border)
  {
    lms3dForTouchedStrips(edge,
      [&](const lms3dCellStrip& strip)
      {
        raster.Set(&lms3dRasterBlock::Touched, strip, true);
        return true;
      });
  }
}
