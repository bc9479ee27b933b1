// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The facets of lms3dBoundedMesher for returns that no patch represents.
#include "LocalMap/Bounded/lms3dBoundedMesher.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace
{
// The size of a facet beyond the axis, where neighbours are close together: as if a neighbour were
// that far away, radians.
constexpr double AngleBeyondAxis = 1e-3;

// The column of each turn, or the row of each beam. `getNumber` returns the turn of a column, or
// the beam of a row. In the halo it returns a number below 0.
template <typename Function>
std::vector<int> FindPlaces(int numbers, int places, const Function& getNumber)
{
  std::vector<int> found(numbers, 0);
  for (int place = 0; place < places; ++place)
  {
    if (getNumber(place) >= 0)
    {
      found[getNumber(place)] = place;
    }
  }
  return found;
}
} // namespace

// Adds a facet for each return beyond the axis, unless it lies within the bound of a patch.
void lms3dBoundedMesher::AddReturnsBeyondAxis(lms3dBoundedMap& map) const
{
  const std::vector<lms3dVector>& points = this->Sphere.GetPointsBeyondAxis();
  std::vector<double> deviations(points.size(), std::numeric_limits<double>::infinity());
  if (map.ReturnsOnPatches > 0)
  {
    tbb::parallel_for(std::size_t(0), points.size(),
      [&](std::size_t i) { deviations[i] = map.GetDeviation(points[i]); });
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (deviations[i] <= this->MaximumError)
    {
      map.LargestDeviation = std::max(map.LargestDeviation, deviations[i]);
      ++map.ReturnsOnPatches;
      continue;
    }
    map.AddFacet(points[i], AngleBeyondAxis);
    ++map.ReturnsOnFacets;
  }
}

void lms3dBoundedMesher::AddSpeckles(
  const std::vector<lms3dGapBeam>& beams, lms3dBoundedMap& map) const
{
  const std::vector<int> columns =
    FindPlaces(this->Grid.GetNumberOfTurns(), this->Sphere.GetNumberOfColumns(),
      [this](int column) { return this->Sphere.GetTurn(this->Sphere.GetIndex(column, 0)); });
  const std::vector<int> rows =
    FindPlaces(this->Grid.GetNumberOfBeams(), this->Sphere.GetNumberOfRows(),
      [this](int row) { return this->Sphere.GetBeam(this->Sphere.GetIndex(0, row)); });
  std::vector<std::pair<GridIndex, double>> ranges;
  ranges.reserve(beams.size());
  for (const lms3dGapBeam& beam : beams)
  {
    ranges.emplace_back(this->Sphere.GetIndex(columns[beam.Turn], rows[beam.Beam]), beam.Range);
  }
  std::sort(ranges.begin(), ranges.end());
  for (const auto& [index, range] : ranges)
  {
    map.AddFacetOnBeam(this->Sphere, index, range);
  }
}

// Adds a facet for each return that left its patch.
void lms3dBoundedMesher::AddFacets(const lms3dPatches& patches, lms3dBoundedMap& map) const
{
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    if (patches.Labels[index] == lms3dPatches::None && this->Sphere.HasReturn(index) &&
      !this->Sphere.IsPoleCopy(index))
    {
      map.AddFacet(this->Sphere, index, this->Sphere.GetRange(index));
      ++map.ReturnsOnFacets;
    }
  }
}
