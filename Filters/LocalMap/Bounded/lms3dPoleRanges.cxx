// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dPoleRanges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace
{
// The returns of one facet span this share of twice the bound, because of rounding.
constexpr double FacetSpan = 1.0 - 1e-9;
} // namespace

lms3dPoleRanges::lms3dPoleRanges(
  const lms3dRangeGrid& grid, double maximumError, lms3dBeamSphere& sphere)
  : Sphere(sphere)
  , MaximumError(maximumError)
{
  for (std::size_t i = 0; i < grid.GetPoles().size(); ++i)
  {
    std::vector<double> ranges = grid.GetRangesOfPoles()[i];
    if (ranges.empty())
    {
      continue;
    }
    std::sort(ranges.begin(), ranges.end());
    const int row = sphere.GetBeam(0) == grid.GetPoles()[i] ? 0 : sphere.GetNumberOfRows() - 1;
    Pole pole = { sphere.GetIndex(0, row), {}, {} };
    const double median = sphere.GetRange(pole.Index);
    const bool areAllNear = ranges.back() - ranges.front() <= 2.0 * maximumError;
    std::partition_copy(ranges.begin(), ranges.end(), std::back_inserter(pole.Near),
      std::back_inserter(pole.Others),
      [&](double range) { return areAllNear || std::abs(range - median) <= maximumError; });
    sphere.SetPole(row, pole.Near.front(), pole.Near.back());
    this->Poles.push_back(pole);
  }
}

// The first return of a pole was counted with the patch, the grid or the facet that represents it.
void lms3dPoleRanges::AddTo(lms3dBoundedMap& map) const
{
  std::int64_t& count = map.ReturnsOnPatches > 0 ? map.ReturnsOnPatches
    : map.ReturnsOnGrid > 0                      ? map.ReturnsOnGrid
                                                 : map.ReturnsOnFacets;
  for (const Pole& pole : this->Poles)
  {
    count += static_cast<std::int64_t>(pole.Near.size()) - 1;
    this->AddFacets(pole, map);
    const lms3dVector direction = this->Sphere.GetDirection(pole.Index);
    const lms3dBoundedMap onPole = map.GetPart(direction);
    for (const std::vector<double>* ranges : { &pole.Near, &pole.Others })
    {
      for (double range : *ranges)
      {
        map.LargestDeviation =
          std::max(map.LargestDeviation, onPole.GetDeviation(lms3dScale(direction, range)));
      }
    }
  }
}

void lms3dPoleRanges::AddFacets(const Pole& pole, lms3dBoundedMap& map) const
{
  const double span = 2.0 * FacetSpan * this->MaximumError;
  for (auto first = pole.Others.begin(); first != pole.Others.end();)
  {
    const auto last = std::upper_bound(first, pole.Others.end(), *first + span);
    map.AddFacet(this->Sphere, pole.Index, 0.5 * (*first + *(last - 1)));
    map.ReturnsOnFacets += last - first;
    first = last;
  }
}
