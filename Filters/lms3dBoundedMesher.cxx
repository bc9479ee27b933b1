// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dBoundedMesher.h"

#include "lms3dGridMesher.h"
#include "lms3dPatchGrower.h"
#include "lms3dPatchMerger.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Patches grow tightly and merge widely, which leaves fewer of them on curved surfaces.
constexpr double GrowingShare = 0.3;
constexpr double GrowingDeviations = 4.0;
// What the planes of a crease may differ by, as a share of the bound.
constexpr double CreaseShare = 0.85;
// One column in so many tells the noise.
constexpr int NoiseStride = 8;
// Standard deviations of noise, as a share of the bound, at which patches give way to the grid.
constexpr double LargestNoise = 0.75;
// The same for the number of patches, as a share of the returns, and for scans of a few returns.
constexpr double MostPatches = 0.125;
constexpr double SmallScan = 256.0;
} // namespace

lms3dBoundedMesher::lms3dBoundedMesher(
  const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, double maximumError)
  : Grid(grid)
  , Joins(joins)
  , MaximumError(maximumError)
  , Sphere(grid, joins)
{
}

// The standard deviation of ranges. On any plane neighbours w of 1/range in a column obey
// w[i-1] + w[i+1] = 2 cos(step) w[i], so what is left of that, times the range squared, is noise of
// six times its variance; its median is little moved by creases and steps.
double lms3dBoundedMesher::EstimateNoise() const
{
  const int rows = this->Sphere.GetNumberOfRows();
  std::vector<double> rests;
  for (int column = 0; column < this->Sphere.GetNumberOfColumns(); column += NoiseStride)
  {
    const double* ranges = this->Sphere.GetRanges() + this->Sphere.GetPlace(column, 0);
    const double* cosines = this->Sphere.GetCosines();
    const double* sines = this->Sphere.GetSines();
    for (int row = 1; row + 1 < rows; ++row)
    {
      if (ranges[row - 1] > 0.0 && ranges[row] > 0.0 && ranges[row + 1] > 0.0)
      {
        // The cosine of half of the step from the row below to the row above.
        const double cosine = 0.5 *
          (cosines[row] * (cosines[row - 1] + cosines[row + 1]) +
            sines[row] * (sines[row - 1] + sines[row + 1]));
        rests.push_back(
          std::abs(1.0 / ranges[row - 1] + 1.0 / ranges[row + 1] - 2.0 * cosine / ranges[row]) *
          ranges[row] * ranges[row]);
      }
    }
  }
  if (rests.empty())
  {
    return 0.0;
  }
  const auto median = rests.begin() + static_cast<std::ptrdiff_t>(rests.size() / 2);
  std::nth_element(rests.begin(), median, rests.end());
  constexpr double DeviationOfMedian = 1.4826;
  return DeviationOfMedian * *median / std::sqrt(6.0);
}

lms3dPatches lms3dBoundedMesher::FindPatches(double noise) const
{
  const double tolerance = std::max(GrowingShare * this->MaximumError, GrowingDeviations * noise);
  lms3dPatches patches = lms3dPatchGrower(this->Sphere, tolerance).Grow();
  lms3dPatchMerger merger(this->Sphere, patches, this->MaximumError, noise);
  merger.Merge();
  merger.MoveBorders();
  merger.TakeSpikes();
  return patches;
}

bool lms3dBoundedMesher::AreTooMany(const std::vector<int>& members) const
{
  const std::int64_t patches =
    static_cast<std::int64_t>(members.size()) - std::count(members.begin(), members.end(), 0);
  return patches > MostPatches * this->Sphere.GetNumberOfReturns() + SmallScan;
}

lms3dBoundedMap lms3dBoundedMesher::MakeMap(
  const double* ranges, const int* beamIds, std::int64_t count)
{
  std::vector<lms3dVector> extremes;
  for (int pole : this->Grid.GetPoles())
  {
    this->SpreadPole(pole, ranges, beamIds, count, extremes);
  }
  lms3dBoundedMap map = this->MakePatchMap();
  for (const lms3dVector& point : extremes)
  {
    map.LargestDeviation = std::max(map.LargestDeviation, map.GetDeviation(point));
  }
  // Those of a pole that go beyond its first return.
  const std::int64_t repeated =
    count - map.ReturnsOnPatches - map.ReturnsOnGrid - map.ReturnsOnFacets;
  (map.ReturnsOnPatches > 0   ? map.ReturnsOnPatches
      : map.ReturnsOnGrid > 0 ? map.ReturnsOnGrid
                              : map.ReturnsOnFacets) += repeated;
  return map;
}

// The returns of a pole are one, and the surface is made for those that the bound allows to be one with
// their median. The extremes of all tell the largest deviation.
void lms3dBoundedMesher::SpreadPole(int beam, const double* ranges, const int* beamIds,
  std::int64_t count, std::vector<lms3dVector>& extremes)
{
  const bool isLowest = this->Sphere.GetBeam(0) == beam;
  const Place place = isLowest ? 0 : this->Sphere.GetNumberOfRows() - 1;
  const double median = this->Sphere.GetRange(place);
  if (!(median > 0.0))
  {
    return;
  }
  std::array<double, 2> near = { median, median };
  std::array<double, 2> all = near;
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (beamIds[i] % this->Grid.GetNumberOfBeams() == beam)
    {
      all = { std::min(all[0], ranges[i]), std::max(all[1], ranges[i]) };
      if (std::abs(ranges[i] - median) <= this->MaximumError)
      {
        near = { std::min(near[0], ranges[i]), std::max(near[1], ranges[i]) };
      }
    }
  }
  // One vertex within the bound of all, if there is one.
  if (all[1] - all[0] <= 2.0 * this->MaximumError)
  {
    near = all;
  }
  this->Sphere.SetPole(this->Sphere.GetRow(place), near[0], near[1]);
  for (double range : all)
  {
    extremes.push_back(lms3dScale(this->Sphere.GetDirection(place), range));
  }
}

lms3dBoundedMap lms3dBoundedMesher::MakePatchMap() const
{
  const double noise = this->EstimateNoise();
  if (noise > LargestNoise * this->MaximumError)
  {
    return this->MakeGridMap();
  }
  lms3dPatches patches = this->FindPatches(noise);
  lms3dBoundedMap map;
  std::vector<int> members;
  do
  {
    members = patches.CountMembers(this->Sphere);
    if (this->AreTooMany(members))
    {
      return this->MakeGridMap();
    }
  } while (!this->TryToMesh(patches, members, map));
  for (Place place = 0; place < this->Sphere.GetNumberOfPlaces(); ++place)
  {
    if (patches.Labels[place] == lms3dPatches::None && this->Sphere.HasReturn(place) &&
      !this->Sphere.IsRepeated(place))
    {
      map.AddFacet(this->Sphere, place, this->Sphere.GetRange(place));
      ++map.ReturnsOnFacets;
    }
  }
  return map;
}

bool lms3dBoundedMesher::TryToMesh(
  lms3dPatches& patches, const std::vector<int>& members, lms3dBoundedMap& map) const
{
  const lms3dBorderGates gates(this->Sphere, patches, CreaseShare * this->MaximumError);
  const lms3dPatchOutlines outlines(this->Sphere, patches, gates);
  lms3dPatchMesher mesher(this->Sphere, patches, outlines, this->MaximumError);
  std::vector<lms3dPatchMesh> meshes(members.size());
  tbb::parallel_for(std::size_t(0), members.size(),
    [&](std::size_t i)
    {
      if (members[i] > 0)
      {
        meshes[i] = mesher.Mesh(static_cast<int>(i), members[i]);
      }
    });
  std::vector<bool> failed(members.size());
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    failed[i] = members[i] > 0 && !meshes[i].IsValid;
  }
  for (std::int32_t patch : outlines.GetUneven())
  {
    failed[patch] = true;
  }
  if (std::find(failed.begin(), failed.end(), true) != failed.end())
  {
    this->Split(patches, members, failed);
    return false;
  }
  this->Append(outlines, meshes, members, map);
  return true;
}

void lms3dBoundedMesher::Append(const lms3dPatchOutlines& outlines,
  const std::vector<lms3dPatchMesh>& meshes, const std::vector<int>& members,
  lms3dBoundedMap& map) const
{
  const auto addPoint = [&](const lms3dMapVertex& vertex)
  {
    map.Points.push_back({ vertex.Direction[0] / vertex.InverseRange,
      vertex.Direction[1] / vertex.InverseRange, vertex.Direction[2] / vertex.InverseRange });
  };
  std::for_each(outlines.GetVertices().begin(), outlines.GetVertices().end(), addPoint);
  const std::int32_t shared = static_cast<std::int32_t>(map.Points.size());
  map.Triangles = outlines.GetBands();
  map.PatchIds.assign(map.Triangles.size(), lms3dBoundedMap::NoPatch);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    if (members[i] == 0)
    {
      continue;
    }
    const std::int32_t offset = static_cast<std::int32_t>(map.Points.size()) - shared;
    std::for_each(meshes[i].Added.begin(), meshes[i].Added.end(), addPoint);
    for (std::array<std::int32_t, 3> triangle : meshes[i].Triangles)
    {
      for (std::int32_t& corner : triangle)
      {
        corner += corner >= shared ? offset : 0;
      }
      map.Triangles.push_back(triangle);
      map.PatchIds.push_back(map.NumberOfPatches);
    }
    ++map.NumberOfPatches;
    map.ReturnsOnPatches += members[i];
    map.LargestDeviation = std::max(map.LargestDeviation, meshes[i].LargestDeviation);
  }
}

// What cannot be meshed as a whole is split into single returns, and those become facets.
void lms3dBoundedMesher::Split(
  lms3dPatches& patches, const std::vector<int>& members, const std::vector<bool>& failed) const
{
  for (Place place = 0; place < this->Sphere.GetNumberOfPlaces(); ++place)
  {
    const std::int32_t label = patches.Labels[place];
    if (label < 0 || label >= static_cast<std::int32_t>(failed.size()) || !failed[label])
    {
      continue;
    }
    if (members[label] == 1)
    {
      patches.Labels[place] = lms3dPatches::None;
      continue;
    }
    if (this->Sphere.IsRepeated(place))
    {
      patches.Labels[place] = patches.Labels[this->Sphere.GetRow(place)];
      continue;
    }
    lms3dPatches::Patch single;
    single.Fit.Add(this->Sphere, place);
    single.Plane = single.Fit.GetPlane();
    patches.Labels[place] = static_cast<std::int32_t>(patches.Patches.size());
    patches.Patches.push_back(single);
  }
}

// Every return is a vertex, and what no triangle of the grid holds gets a facet.
lms3dBoundedMap lms3dBoundedMesher::MakeGridMap() const
{
  lms3dBoundedMap map;
  map.Points.resize(this->Grid.GetReturns().size());
  std::vector<Place> places(map.Points.size());
  lms3dGridPoints points;
  points.SetShape(this->Grid);
  for (Place place = 0; place < this->Sphere.GetNumberOfPlaces(); ++place)
  {
    const int turn = this->Sphere.GetTurn(place);
    if (turn >= 0 && this->Sphere.HasReturn(place))
    {
      const std::int32_t vertex = this->Grid.GetVertex(turn, this->Sphere.GetBeam(place));
      const lms3dVector direction = this->Sphere.GetDirection(place);
      const double range = this->Sphere.GetRange(place);
      map.Points[vertex] = lms3dScale(direction, range);
      places[vertex] = place;
      for (int axis = 0; axis < 3; ++axis)
      {
        points.GetRow(axis, turn)[this->Sphere.GetBeam(place)] = map.Points[vertex][axis];
      }
    }
  }
  points.FillGhosts(this->Grid);
  lms3dGridMesher mesher;
  mesher.ChooseTriangles(this->Grid, this->Joins, points);
  std::vector<std::int32_t> corners(3 * mesher.GetNumberOfTriangles());
  mesher.FillTriangles(this->Grid, corners.data());

  const bool isMirrored = this->Grid.GetGeometry().IsMirrored();
  std::vector<bool> isMet(map.Points.size(), false);
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::array<std::int32_t, 3> triangle;
    for (int j = 0; j < 3; ++j)
    {
      triangle[j] = corners[i + j];
    }
    if (isMirrored)
    {
      std::swap(triangle[1], triangle[2]);
    }
    // A cell that is wider than half a circle has no front.
    if (map.IsFacing(triangle))
    {
      map.Triangles.push_back(triangle);
      for (std::int32_t corner : triangle)
      {
        isMet[corner] = true;
      }
    }
  }
  map.PatchIds.assign(map.Triangles.size(), lms3dBoundedMap::NoPatch);
  map.ReturnsOnGrid = std::count(isMet.begin(), isMet.end(), true);
  for (std::size_t vertex = 0; vertex < isMet.size(); ++vertex)
  {
    if (!isMet[vertex])
    {
      map.AddFacet(this->Sphere, places[vertex], this->Sphere.GetRange(places[vertex]));
      ++map.ReturnsOnFacets;
    }
  }
  map.DropUnusedPoints();
  return map;
}
