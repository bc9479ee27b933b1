// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dGrowingMap.h"

#include "Fusion/lms3dPassedBeams.h"
#include "Fusion/lms3dRasterRows.h"
#include "Geometry/lms3dTriangleDistance.h"

#include <vtkPolyData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace
{
// Cells for each bound.
constexpr double CellsPerBound = 3.0;
// As a share of the bound: how far a return may be from its plane. The rest is for rounding.
constexpr double ReturnShare = 0.97;
// As a share of the bound: how far the returns of a patch, apart from their noise, may be from a plane that the patch joins.
constexpr double MatchShare = 0.4;
constexpr double NoiseFactor = 4.0;
// A patch is curved if the root mean square of the distances of its returns exceeds this share of the bound, and if
// successive distances are correlated.
constexpr double CurvedShare = 0.05;
constexpr double SmallestCorrelation = 0.5;
// If other planes explain this share of a patch, it needs no plane of its own.
constexpr double ExplainedShare = 0.7;
// The share of a patch's returns that need not fit the plane.
constexpr double MisfitShare = 0.05;
// As a share of the bound: how far the returns of a single triangle may be from the plane that it joins.
constexpr double JoinShare = 0.9;
// As a share of the bound: returns farther from the plane of their patch may lie on another plane beside it.
constexpr double LooseShare = 0.2;
// The cosine of the largest angle between a patch and the plane that it joins.
constexpr double SmallestCosine = 0.9;
// The sine of the smallest angle at a crease.
constexpr double SmallestSine = 0.17;
// Cells: how far the edge of a local map may be from the line in which its planes meet.
constexpr double CreaseReach = 6.0;
// Cells: the circumradius of a facet.
constexpr double FacetRadius = 0.25;
// Cells: how much a crease grows before it changes its planes.
constexpr double CreaseGrowth = 16.0;
// A plane of a patch with fewer returns is weak, until it has the second number.
constexpr std::size_t SmallestStrongCount = 3000;
constexpr std::size_t LargestWeakCount = 20000;
// The share of a weak plane's returns that other planes must explain to take its place.
constexpr double DissolvedShare = 0.9;
constexpr double TimeOfCasting = 0.3;
constexpr double TimeOfMarking = 0.5;
// How many planes get new triangles between two looks at the progress.
constexpr std::size_t PlanesOfStep = 32;

lms3dVector GetCorner(const lms3dLocalMap& local, int triangle, int corner)
{
  const double* point = local.Mesh.GetCorner(triangle, corner);
  return { point[0], point[1], point[2] };
}

// Returns whether the parts grew by more than the gap that they may have.
bool Merge(lms3dCreaseParts& parts, double first, double last, double gap)
{
  for (const auto& part : parts)
  {
    if (first >= part.first - gap && last <= part.second + gap)
    {
      return false;
    }
  }
  parts.emplace_back(first, last);
  std::sort(parts.begin(), parts.end());
  lms3dCreaseParts merged;
  for (const auto& part : parts)
  {
    if (!merged.empty() && part.first <= merged.back().second + gap)
    {
      merged.back().second = std::max(merged.back().second, part.second);
    }
    else
    {
      merged.push_back(part);
    }
  }
  parts = merged;
  return true;
}

std::vector<lms3dMappedReturn> Select(const lms3dLocalMap& local, const std::vector<int>& numbers)
{
  std::vector<lms3dMappedReturn> returns;
  returns.reserve(numbers.size());
  for (int i : numbers)
  {
    returns.push_back(local.Returns[i]);
  }
  return returns;
}

/// The line in which two planes meet.
struct Line
{
  lms3dVector Point;
  /// The cross product of the normals, scaled to length 1.
  lms3dVector Direction;
};

bool Intersect(const lms3dPlaneFrame& a, const lms3dPlaneFrame& b, Line& line)
{
  const lms3dVector cross = lms3dCross(a.GetNormal(), b.GetNormal());
  const double square = lms3dDot(cross, cross);
  if (square < SmallestSine * SmallestSine)
  {
    return false;
  }
  const double offsetA = -a.GetHeight({ 0.0, 0.0, 0.0 });
  const double offsetB = -b.GetHeight({ 0.0, 0.0, 0.0 });
  line.Point = lms3dScale(lms3dAdd(lms3dScale(lms3dCross(b.GetNormal(), cross), offsetA),
                            lms3dScale(lms3dCross(cross, a.GetNormal()), offsetB)),
    1.0 / square);
  line.Direction = lms3dNormalize(cross);
  return true;
}
} // namespace

lms3dGrowingMap::lms3dGrowingMap(const lms3dFusionSettings& settings)
  : Settings(settings)
  , Cell(settings.MaximumError / CellsPerBound)
{
}

void lms3dGrowingMap::AddTable(const lms3dScanInput& scan)
{
  if (!this->Table || !scan.HasAngles(this->Table->GetGeometry()))
  {
    this->Table = std::make_shared<lms3dBeamTable>(scan.GetGeometry());
  }
}

bool lms3dGrowingMap::Add(
  vtkPolyData* map, const lms3dScanInput& scan, const lms3dProgress& progress)
{
  if (map->GetNumberOfPolys() == 0)
  {
    this->Positions.push_back(
      scan.GetNumberOfReturns() > 0 ? scan.GetSensorPosition() : lms3dVector{ 0.0, 0.0, 0.0 });
    return progress(1.0);
  }
  this->AddTable(scan);
  this->Positions.push_back(scan.GetSensorPosition());
  auto ranges = std::make_unique<lms3dSeenRanges>(scan, this->Table);
  const lms3dLocalMap local(map, scan, *ranges, this->Settings.MaximumError);
  if (!progress(TimeOfCasting))
  {
    return false;
  }
  if (this->Settings.ForgetSeenThrough)
  {
    this->MarkPassed(*ranges, true, false);
  }
  this->Join(local);
  this->MarkPassed(*ranges, false, false);
  for (const std::unique_ptr<lms3dSeenRanges>& earlier : this->Seen)
  {
    this->MarkPassed(*earlier, false, true);
  }
  if (this->Settings.KeepReturns)
  {
    this->Seen.push_back(std::move(ranges));
  }
  this->DissolveWeakPlanes();
  if (!progress(TimeOfMarking))
  {
    return false;
  }
  return this->Renew(lms3dGetStepProgress(progress, TimeOfMarking, 1.0));
}

// A weak plane goes if other planes explain nearly all of its returns. The rest of them get facets.
void lms3dGrowingMap::DissolveWeakPlanes()
{
  const std::size_t end = this->Planes.size();
  for (std::size_t i = 0; i < end; ++i)
  {
    lms3dFusedPlane& plane = this->Planes[i];
    if (!plane.IsWeak || (!plane.IsChanged && !plane.IsSeen) || plane.Returns.empty())
    {
      continue;
    }
    std::vector<int> others = this->FindPlanesNear(plane.Returns, end);
    others.erase(std::remove(others.begin(), others.end(), static_cast<int>(i)), others.end());
    if (this->CountShown(others, plane.Returns) <
      DissolvedShare * static_cast<double>(plane.Returns.size()))
    {
      continue;
    }
    std::vector<lms3dMappedReturn> returns;
    returns.swap(plane.Returns);
    plane.Raster = {};
    plane.Verbatim.clear();
    plane.OldBlocks = 0;
    plane.IsWeak = false;
    plane.IsChanged = true;
    for (const lms3dMappedReturn& mapped : returns)
    {
      if (!this->AddToPlanes(others, mapped))
      {
        this->AddFacet(mapped);
      }
    }
  }
}

// The threads divide the planes. A plane depends on the frames of other planes alone.
bool lms3dGrowingMap::Renew(const lms3dProgress& progress)
{
  std::vector<int> changed;
  for (std::size_t i = 0; i < this->Planes.size(); ++i)
  {
    lms3dFusedPlane& plane = this->Planes[i];
    plane.OldBlocks = plane.Raster.GetNumberOfBlocks();
    if (plane.IsChanged || plane.IsSeen)
    {
      changed.push_back(static_cast<int>(i));
    }
  }
  const std::size_t count = changed.size();
  for (std::size_t first = 0; first < count; first += PlanesOfStep)
  {
    const std::size_t end = std::min(first + PlanesOfStep, count);
    tbb::parallel_for(first, end, [&](std::size_t i) { this->RenewPlane(changed[i]); });
    if (!progress(static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

void lms3dGrowingMap::RenewPlane(int number)
{
  lms3dFusedPlane& plane = this->Planes[number];
  if (plane.IsChanged)
  {
    lms3dMakeRegionMesh(plane, this->GetCreaseLines(number), this->Settings.MaximumError);
    plane.Revision = this->GetNumberOfScans();
  }
  lms3dSetSightings(plane);
  plane.IsChanged = false;
  plane.IsSeen = false;
}

void lms3dGrowingMap::Join(const lms3dLocalMap& local)
{
  std::vector<int> planeOfPatch(static_cast<std::size_t>(local.NumberOfPatches), -1);
  std::vector<bool> isExplained(local.Returns.size());
  const std::vector<std::vector<int>> returns = lms3dGetReturnsOfPatches(local);
  const std::size_t planesBefore = this->Planes.size();
  std::map<int, std::vector<int>> loose;
  for (int patch = 0; patch < local.NumberOfPatches; ++patch)
  {
    const auto fit = lms3dFitPlane(local, returns[patch], this->Settings.MaximumError);
    if (!fit)
    {
      continue;
    }
    planeOfPatch[patch] = this->FindPlane(local, returns[patch], *fit);
    if (planeOfPatch[patch] < 0 && fit->Deviation <= MatchShare * this->Settings.MaximumError &&
      !this->IsMostlyExplained(Select(local, returns[patch]), planesBefore))
    {
      planeOfPatch[patch] = this->MakePlane(fit->Centre, fit->Normal);
      this->Planes.back().IsCurved = fit->Correlation > SmallestCorrelation &&
        fit->Deviation > CurvedShare * this->Settings.MaximumError;
      this->Planes.back().IsWeak =
        this->Planes.back().IsCurved || returns[patch].size() < SmallestStrongCount;
    }
    if (planeOfPatch[patch] < 0)
    {
      continue;
    }
    const lms3dPlaneFrame& frame = this->Planes[planeOfPatch[patch]].Frame;
    const double near =
      std::max(LooseShare * this->Settings.MaximumError, NoiseFactor * fit->Deviation);
    for (int i : returns[patch])
    {
      if (std::abs(frame.GetHeight(local.Returns[i].Point)) > near)
      {
        loose[patch].push_back(i);
        continue;
      }
      isExplained[i] = this->AddReturn(planeOfPatch[patch], local.Returns[i]);
    }
  }
  for (std::size_t triangle = 0; triangle < local.PatchIds.size(); ++triangle)
  {
    const int patch = local.PatchIds[triangle];
    if (patch >= 0 && planeOfPatch[patch] >= 0)
    {
      this->AddTriangle(planeOfPatch[patch], local, static_cast<int>(triangle));
    }
  }
  for (const auto& [patch, numbers] : loose)
  {
    this->AddLoose(local, numbers, planeOfPatch[patch], isExplained);
  }
  this->AddCreases(local, planeOfPatch);
  this->AddRest(local, isExplained, planeOfPatch);
}

int lms3dGrowingMap::FindPlane(
  const lms3dLocalMap& local, const std::vector<int>& returns, const lms3dFittedPlane& fit) const
{
  const double bound = std::min(ReturnShare * this->Settings.MaximumError,
    MatchShare * this->Settings.MaximumError + NoiseFactor * fit.Deviation);
  int best = -1;
  double least = 0.0;
  for (std::size_t i = 0; i < this->Planes.size(); ++i)
  {
    const lms3dFusedPlane& plane = this->Planes[i];
    const double distance = std::abs(plane.Frame.GetHeight(fit.Centre));
    if (!plane.Verbatim.empty() || plane.IsCurved || distance > bound ||
      lms3dDot(plane.Frame.GetNormal(), fit.Normal) < SmallestCosine ||
      (best >= 0 && distance >= least))
    {
      continue;
    }
    const auto misfits = std::count_if(returns.begin(), returns.end(),
      [&](int number)
      {
        const lms3dMappedReturn& mapped = local.Returns[number];
        return !plane.Explains(mapped.Point, mapped.Direction, bound);
      });
    if (static_cast<double>(misfits) <= MisfitShare * static_cast<double>(returns.size()))
    {
      best = static_cast<int>(i);
      least = distance;
    }
  }
  return best;
}

int lms3dGrowingMap::MakePlane(const lms3dVector& point, const lms3dVector& normal)
{
  this->Planes.emplace_back(lms3dPlaneFrame(point, normal, this->Cell));
  return static_cast<int>(this->Planes.size()) - 1;
}

void lms3dGrowingMap::AddTriangle(int number, const lms3dLocalMap& local, int triangle)
{
  lms3dFusedPlane& plane = this->Planes[number];
  std::array<lms3dPoint2, 3> cells;
  for (int corner = 0; corner < 3; ++corner)
  {
    const lms3dVector point = GetCorner(local, triangle, corner);
    cells[corner] = plane.Frame.ToCells(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      plane.Low[axis] = std::min(plane.Low[axis], point[axis]);
      plane.High[axis] = std::max(plane.High[axis], point[axis]);
    }
  }
  lms3dForTouchedRows(cells,
    [&](std::int32_t row, std::int32_t first, std::int32_t last)
    {
      plane.Raster.SetRow(&lms3dRasterBlock::May, row, first, last, true, true, [](int) {});
      return true;
    });
}

bool lms3dGrowingMap::IsCovered(
  const lms3dFusedPlane& plane, const lms3dRasterBlock& block, std::int32_t u, std::int32_t v) const
{
  if ((block.Covered[lms3dRaster::GetPlaceOf(v)] >> lms3dRaster::GetPlaceOf(u) & 1U) != 0)
  {
    return true;
  }
  const int reach = lms3dGetCoveredReach(block.Deviation, this->Cell, this->Settings.MaximumError);
  for (std::int32_t row = v - reach; row <= v + reach; ++row)
  {
    if (plane.Raster.HasAny(&lms3dRasterBlock::Covered, row, u - reach, u + reach))
    {
      return true;
    }
  }
  return false;
}

bool lms3dGrowingMap::AddReturn(int number, const lms3dMappedReturn& mapped)
{
  lms3dFusedPlane& plane = this->Planes[number];
  if (!plane.Explains(mapped.Point, mapped.Direction, ReturnShare * this->Settings.MaximumError))
  {
    return false;
  }
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = static_cast<std::int32_t>(std::floor(place[0]));
  const auto v = static_cast<std::int32_t>(std::floor(place[1]));
  lms3dRasterBlock& block = plane.Raster.GetBlock(
    plane.Raster.Make(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v)));
  std::uint64_t& word = block.Must[lms3dRaster::GetPlaceOf(v)];
  const std::uint64_t bit = std::uint64_t{ 1 } << lms3dRaster::GetPlaceOf(u);
  plane.IsSeen = true;
  if (plane.IsWeak)
  {
    plane.Returns.push_back(mapped);
    if (plane.Returns.size() > LargestWeakCount)
    {
      plane.IsWeak = false;
      plane.Returns = {};
    }
  }
  word |= bit;
  block.Deviation = std::max(block.Deviation, std::abs(plane.Frame.GetHeight(mapped.Point)));
  plane.IsChanged = plane.IsChanged || !this->IsCovered(plane, block, u, v);
  const int scan = this->GetNumberOfScans() - 1;
  block.Sightings.ScanCount += block.Sightings.LastScan != scan ? 1 : 0;
  block.Sightings.LastScan = scan;
  const double quality =
    -lms3dDot(plane.Frame.GetNormal(), mapped.Direction) / (mapped.Range * mapped.Range);
  if (quality > block.Quality)
  {
    block.Quality = quality;
    block.Sightings.BestScan = scan;
  }
  return true;
}

void lms3dGrowingMap::AddCreases(const lms3dLocalMap& local, const std::vector<int>& planeOfPatch)
{
  // The triangles at each edge of the local map.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> planeOfEdge;
  for (std::size_t triangle = 0; triangle < local.PatchIds.size(); ++triangle)
  {
    const int patch = local.PatchIds[triangle];
    const int plane = patch < 0 ? -1 : planeOfPatch[patch];
    if (plane < 0)
    {
      continue;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t a = local.Mesh.Triangles[triangle][corner];
      const std::uint32_t b = local.Mesh.Triangles[triangle][(corner + 1) % 3];
      const auto [place, isNew] = planeOfEdge.try_emplace(std::minmax(a, b), plane);
      if (isNew || place->second == plane)
      {
        continue;
      }
      const int first = std::min(plane, place->second);
      const int second = std::max(plane, place->second);
      Line line;
      if (!Intersect(this->Planes[first].Frame, this->Planes[second].Frame, line))
      {
        continue;
      }
      double along[2];
      double farthest = 0.0;
      for (int end = 0; end < 2; ++end)
      {
        const lms3dVector v = lms3dSubtract(local.Mesh.Points[end == 0 ? a : b], line.Point);
        along[end] = lms3dDot(v, line.Direction);
        farthest = std::max(
          farthest, lms3dGetLength(lms3dSubtract(v, lms3dScale(line.Direction, along[end]))));
      }
      if (farthest <= CreaseReach * this->Cell)
      {
        lms3dCreaseParts& parts = this->Planes[first].Creases[second];
        const bool isLonger = Merge(parts, std::min(along[0], along[1]),
          std::max(along[0], along[1]), CreaseGrowth * this->Cell);
        this->Planes[second].Creases[first] = parts;
        this->Planes[first].IsChanged = this->Planes[first].IsChanged || isLonger;
        this->Planes[second].IsChanged = this->Planes[second].IsChanged || isLonger;
      }
    }
  }
}

namespace
{
// Whether a return is near enough to a triangle of a local map that is a region of its own.
bool IsAtVerbatim(const lms3dFusedPlane& plane, const lms3dVector& point, double bound)
{
  return plane.Verbatim.empty() ||
    std::any_of(plane.Verbatim.begin(), plane.Verbatim.end(),
      [&](const std::array<lms3dVector, 3>& corners)
      { return lms3dGetDistance(point, corners[0], corners[1], corners[2]) <= bound; });
}
} // namespace

bool lms3dGrowingMap::Shows(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const
{
  const double bound = ReturnShare * this->Settings.MaximumError;
  if (lms3dDot(plane.Frame.GetNormal(), mapped.Direction) >= 0.0 ||
    !plane.Explains(mapped.Point, mapped.Direction, bound))
  {
    return false;
  }
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = static_cast<std::int32_t>(std::floor(place[0]));
  const auto v = static_cast<std::int32_t>(std::floor(place[1]));
  return plane.Raster.Has(&lms3dRasterBlock::May, u, v) &&
    !plane.Raster.Has(&lms3dRasterBlock::Open, u, v) &&
    !plane.Raster.Has(&lms3dRasterBlock::Passed, u, v) && IsAtVerbatim(plane, mapped.Point, bound);
}

// The planes, out of the first `end`, whose boxes meet the box of returns.
std::vector<int> lms3dGrowingMap::FindPlanesNear(
  const std::vector<lms3dMappedReturn>& returns, std::size_t end) const
{
  lms3dVector low = { 1e300, 1e300, 1e300 };
  lms3dVector high = { -1e300, -1e300, -1e300 };
  for (const lms3dMappedReturn& mapped : returns)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], mapped.Point[axis]);
      high[axis] = std::max(high[axis], mapped.Point[axis]);
    }
  }
  std::vector<int> planes;
  const double bound = this->Settings.MaximumError;
  for (std::size_t i = 0; i < end; ++i)
  {
    const lms3dFusedPlane& plane = this->Planes[i];
    bool isNear = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isNear =
        isNear && high[axis] >= plane.Low[axis] - bound && low[axis] <= plane.High[axis] + bound;
    }
    if (isNear)
    {
      planes.push_back(static_cast<int>(i));
    }
  }
  return planes;
}

double lms3dGrowingMap::CountShown(
  const std::vector<int>& planes, const std::vector<lms3dMappedReturn>& returns) const
{
  return static_cast<double>(std::count_if(returns.begin(), returns.end(),
    [&](const lms3dMappedReturn& mapped)
    {
      return std::any_of(planes.begin(), planes.end(),
        [&](int plane) { return this->Shows(this->Planes[plane], mapped); });
    }));
}

bool lms3dGrowingMap::IsMostlyExplained(
  const std::vector<lms3dMappedReturn>& returns, std::size_t end) const
{
  return this->CountShown(this->FindPlanesNear(returns, end), returns) >=
    ExplainedShare * static_cast<double>(returns.size());
}

// Adds each return to the plane that is nearest to it.
void lms3dGrowingMap::AddLoose(const lms3dLocalMap& local, const std::vector<int>& returns,
  int ownPlane, std::vector<bool>& isExplained)
{
  const std::vector<int> planes = this->FindPlanesNear(Select(local, returns), this->Planes.size());
  for (int i : returns)
  {
    const lms3dMappedReturn& mapped = local.Returns[i];
    int best = ownPlane;
    double least = std::abs(this->Planes[ownPlane].Frame.GetHeight(mapped.Point));
    for (int plane : planes)
    {
      const double distance = std::abs(this->Planes[plane].Frame.GetHeight(mapped.Point));
      if (distance < least && this->Shows(this->Planes[plane], mapped))
      {
        best = plane;
        least = distance;
      }
    }
    isExplained[i] = this->AddReturn(best, mapped);
  }
}

bool lms3dGrowingMap::AddToPlanes(const std::vector<int>& planes, const lms3dMappedReturn& mapped)
{
  return std::any_of(planes.begin(), planes.end(),
    [&](int plane)
    { return this->Shows(this->Planes[plane], mapped) && this->AddReturn(plane, mapped); });
}

// The plane that explains all returns of a triangle beside it.
int lms3dGrowingMap::FindPlaneBeside(const lms3dLocalMap& local, const std::vector<int>& returns,
  const std::array<lms3dVector, 3>& corners, const lms3dVector& normal) const
{
  const double bound = JoinShare * this->Settings.MaximumError;
  for (std::size_t i = 0; i < this->Planes.size(); ++i)
  {
    const lms3dFusedPlane& plane = this->Planes[i];
    bool isNear =
      plane.Verbatim.empty() && lms3dDot(plane.Frame.GetNormal(), normal) >= SmallestCosine;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] =
        std::minmax({ corners[0][axis], corners[1][axis], corners[2][axis] });
      isNear = isNear && high >= plane.Low[axis] - bound && low <= plane.High[axis] + bound;
    }
    if (isNear &&
      std::all_of(returns.begin(), returns.end(),
        [&](int number)
        {
          const lms3dMappedReturn& mapped = local.Returns[number];
          return plane.Explains(mapped.Point, mapped.Direction, bound);
        }))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void lms3dGrowingMap::AddRest(const lms3dLocalMap& local, const std::vector<bool>& isExplained,
  const std::vector<int>& planeOfPatch)
{
  std::map<int, std::vector<int>> restOf;
  for (std::size_t i = 0; i < local.Returns.size(); ++i)
  {
    if (!isExplained[i])
    {
      restOf[local.Returns[i].Triangle].push_back(static_cast<int>(i));
    }
  }
  std::map<int, std::vector<int>> returnsOf;
  for (const auto& [triangle, rest] : restOf)
  {
    const std::vector<int> planes = this->FindPlanesNear(Select(local, rest), this->Planes.size());
    const int patch = local.PatchIds[triangle];
    for (int i : rest)
    {
      if (this->AddToPlanes(planes, local.Returns[i]))
      {
        continue;
      }
      if (patch >= 0 && planeOfPatch[patch] >= 0)
      {
        this->AddFacet(local.Returns[i]);
        continue;
      }
      returnsOf[triangle].push_back(i);
    }
  }
  for (const auto& [triangle, returns] : returnsOf)
  {
    const std::array<lms3dVector, 3> corners = { GetCorner(local, triangle, 0),
      GetCorner(local, triangle, 1), GetCorner(local, triangle, 2) };
    const lms3dVector normal = lms3dNormalize(
      lms3dGetWeightedNormal({ corners[0].data(), corners[1].data(), corners[2].data() }));
    int number = this->FindPlaneBeside(local, returns, corners, normal);
    if (number < 0)
    {
      number = this->MakePlane(corners[0], normal);
      this->Planes[number].Verbatim.push_back(corners);
      this->Planes[number].IsCurved = true;
      this->Planes[number].IsWeak = true;
    }
    this->AddTriangle(number, local, triangle);
    for (int i : returns)
    {
      if (!this->AddReturn(number, local.Returns[i]))
      {
        this->AddFacet(local.Returns[i]);
      }
    }
  }
}

// A small triangle around a return, across its beam.
void lms3dGrowingMap::AddFacet(const lms3dMappedReturn& mapped)
{
  const lms3dVector normal = lms3dScale(mapped.Direction, -1.0);
  const int number = this->MakePlane(mapped.Point, normal);
  const lms3dPoint2 centre = this->Planes[number].Frame.ToCells(mapped.Point);
  const double half = FacetRadius * std::sqrt(0.75);
  const lms3dPlaneFrame& frame = this->Planes[number].Frame;
  this->Planes[number].Verbatim.push_back(
    { frame.ToWorld({ centre[0] - half, centre[1] - FacetRadius / 2.0 }),
      frame.ToWorld({ centre[0] + half, centre[1] - FacetRadius / 2.0 }),
      frame.ToWorld({ centre[0], centre[1] + FacetRadius }) });
  this->AddReturn(number, mapped);
}

void lms3dGrowingMap::MarkPassed(const lms3dSeenRanges& ranges, bool forgets, bool newBlocksOnly)
{
  tbb::parallel_for(std::size_t{ 0 }, this->Planes.size(),
    [&](std::size_t i)
    {
      lms3dFusedPlane& plane = this->Planes[i];
      lms3dPassedBeams beams(ranges, this->Settings.MaximumError, forgets);
      const int first = newBlocksOnly ? plane.OldBlocks : 0;
      for (int block = first; block < plane.Raster.GetNumberOfBlocks(); ++block)
      {
        beams.Mark(plane, block);
      }
    });
}

std::vector<lms3dCreaseLine> lms3dGrowingMap::GetCreaseLines(int number) const
{
  const lms3dFusedPlane& plane = this->Planes[number];
  std::vector<lms3dCreaseLine> lines;
  for (const auto& [other, parts] : plane.Creases)
  {
    Line line;
    const lms3dPlaneFrame& first = this->Planes[std::min(number, other)].Frame;
    const lms3dPlaneFrame& second = this->Planes[std::max(number, other)].Frame;
    if (!Intersect(first, second, line))
    {
      continue;
    }
    lms3dCreaseLine inCells;
    inCells.Point = plane.Frame.ToCells(line.Point);
    const lms3dPoint2 ahead = plane.Frame.ToCells(lms3dAdd(line.Point, line.Direction));
    inCells.Direction = { (ahead[0] - inCells.Point[0]) * this->Cell,
      (ahead[1] - inCells.Point[1]) * this->Cell };
    for (const auto& [from, to] : parts)
    {
      inCells.Parts.emplace_back(from / this->Cell, to / this->Cell);
    }
    lines.push_back(inCells);
  }
  return lines;
}
