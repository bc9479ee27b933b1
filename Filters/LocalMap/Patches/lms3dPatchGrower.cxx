// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchGrower.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace
{
constexpr int CoarsestStride = 16;
constexpr int MaximumFloods = 5;
// A plane has converged if a new fit moves it by less than this share of the tolerance.
constexpr double ConvergedShare = 0.05;

// Without branches, so that the compiler makes it a loop over vectors.
bool HasAny(const std::int32_t* labels, int count, std::int32_t value)
{
  std::int32_t found = 0;
  for (int i = 0; i < count; ++i)
  {
    found |= labels[i] == value ? 1 : 0;
  }
  return found != 0;
}
} // namespace

lms3dPatchGrower::lms3dPatchGrower(const lms3dBeamSphere& sphere, double tolerance)
  : Sphere(sphere)
  , Tolerance(tolerance)
  , SeedPlanes(sphere, this->Result, tolerance)
  , Runs(sphere.GetNumberOfRows())
{
  this->Result.Labels.resize(sphere.GetSize());
  std::transform(sphere.GetRanges(), sphere.GetRanges() + sphere.GetSize(),
    this->Result.Labels.begin(),
    [](double range) { return range > 0.0 ? lms3dPatches::Free : lms3dPatches::None; });
}

lms3dPatches lms3dPatchGrower::Grow()
{
  for (int stride = CoarsestStride; stride > 1; stride /= 2)
  {
    this->GrowFromLattice(stride);
  }
  this->GrowFromFreeReturns();
  return std::move(this->Result);
}

void lms3dPatchGrower::GrowFromLattice(int stride)
{
  for (int column = stride / 2; column < this->Sphere.GetNumberOfColumns(); column += stride)
  {
    for (int row = stride / 2; row + stride / 2 < this->Sphere.GetNumberOfRows(); row += stride)
    {
      const GridIndex seed = this->Sphere.GetIndex(column, row);
      const std::optional<lms3dPlane> plane =
        this->IsFree(seed) ? this->SeedPlanes.FitWindow(column, row, stride) : std::nullopt;
      if (plane)
      {
        this->GrowFrom(seed, *plane);
      }
    }
  }
}

void lms3dPatchGrower::GrowFromFreeReturns()
{
  for (GridIndex seed = 0; seed < this->Sphere.GetSize(); ++seed)
  {
    if (this->IsFree(seed))
    {
      this->GrowFrom(seed, this->SeedPlanes.FitNeighbors(seed));
    }
  }
}

void lms3dPatchGrower::GrowFrom(GridIndex seed, lms3dPlane plane)
{
  lms3dPatches::Patch patch;
  for (int flood = 1;; ++flood)
  {
    patch.Plane = plane;
    this->Flood(seed, plane, patch);
    plane = patch.Fit.GetPlane();
    if (flood == MaximumFloods || !this->HasMoved(patch, plane) || !this->Fits(seed, plane))
    {
      break;
    }
    this->Release(patch);
  }
  this->Result.Patches.push_back(std::move(patch));
}

// Whether a new plane differs from the patch's plane by more than the convergence threshold.
bool lms3dPatchGrower::HasMoved(const lms3dPatches::Patch& patch, const lms3dPlane& plane) const
{
  if (patch.Fit.GetNumberOfReturns() < 3)
  {
    return false;
  }
  return std::any_of(patch.Spans.begin(), patch.Spans.end(),
    [&](const Span& span)
    {
      const lms3dVector direction = this->Sphere.GetDirection(span.First);
      const double range = this->Sphere.GetRange(span.First);
      const double moved =
        plane.GetInverseRange(direction) - patch.Plane.GetInverseRange(direction);
      return std::abs(moved) * range * range > ConvergedShare * this->Tolerance;
    });
}

// Makes all returns of a patch free again.
void lms3dPatchGrower::Release(lms3dPatches::Patch& patch)
{
  for (const Span& span : patch.Spans)
  {
    std::fill(this->Result.Labels.begin() + span.First, this->Result.Labels.begin() + span.Last + 1,
      lms3dPatches::Free);
  }
  patch.Spans.clear();
  patch.Fit = {};
}

void lms3dPatchGrower::Flood(GridIndex seed, const lms3dPlane& plane, lms3dPatches::Patch& patch)
{
  const int rows = this->Sphere.GetNumberOfRows();
  this->Queue.assign(1, { seed, seed });
  while (!this->Queue.empty())
  {
    const Span run = this->Queue.back();
    this->Queue.pop_back();
    // A flood that reached one of its returns reached them all.
    if (!this->IsFree(run.First))
    {
      continue;
    }
    const int column = this->Sphere.GetColumn(run.First);
    const Span span = this->FloodSpan(run, lms3dColumnPlane(plane, this->Sphere, column));
    patch.Spans.push_back(span);
    patch.Fit.Add(this->Sphere, column, span.First - column * rows, span.Last - column * rows);
    this->QueueNeighbors(span, lms3dBeamSphere::Left, plane);
    this->QueueNeighbors(span, lms3dBeamSphere::Right, plane);
  }
}

lms3dPatches::Span lms3dPatchGrower::FloodSpan(const Span& run, const lms3dColumnPlane& plane)
{
  const GridIndex column = run.First - this->Sphere.GetRow(run.First);
  const GridIndex end = column + this->Sphere.GetNumberOfRows() - 1;
  const auto fits = [&](GridIndex index)
  {
    const int row = index - column;
    return this->IsFree(index) &&
      lms3dIsWithinTolerance(
        this->Sphere.GetRange(index), plane.GetInverseRange(row), this->Tolerance);
  };
  Span span = run;
  while (span.First > column && this->Sphere.IsJoined(span.First - 1, lms3dBeamSphere::Up) &&
    fits(span.First - 1))
  {
    --span.First;
  }
  while (
    span.Last < end && this->Sphere.IsJoined(span.Last, lms3dBeamSphere::Up) && fits(span.Last + 1))
  {
    ++span.Last;
  }
  const std::int32_t label = static_cast<std::int32_t>(this->Result.Patches.size());
  std::fill(
    this->Result.Labels.begin() + span.First, this->Result.Labels.begin() + span.Last + 1, label);
  return span;
}

// Queues each run of fitting returns. It may go on beyond the ends of the span.
void lms3dPatchGrower::QueueNeighbors(const Span& span, int side, const lms3dPlane& plane)
{
  const GridIndex first = this->Sphere.GetNeighbor(span.First, side);
  const int count = span.Last - span.First + 1;
  if (!HasAny(this->Result.Labels.data() + first, count, lms3dPatches::Free))
  {
    return;
  }
  const int column = this->Sphere.GetColumn(first);
  const lms3dColumnPlane inColumn(plane, this->Sphere, column);
  const Neighbors neighbors = { first, side == lms3dBeamSphere::Left ? first : span.First,
    first - this->Sphere.GetIndex(column, 0), count };
  this->Sphere.IsRegular() ? this->MarkOpenOfRegular(neighbors, inColumn)
                           : this->MarkOpen(neighbors, inColumn);
  this->Runs.ForEach(this->Sphere.GetJoins() + first, count,
    [&](int begin, int end) {
      this->Queue.push_back({ first + begin, first + end });
    });
}

// Marks the entries to which the flood can go on.
void lms3dPatchGrower::MarkOpen(const Neighbors& neighbors, const lms3dColumnPlane& plane)
{
  for (int i = 0; i < neighbors.Count; ++i)
  {
    const GridIndex index = neighbors.First + i;
    const bool isOpen = this->IsFree(index) &&
      this->Sphere.IsJoined(neighbors.FirstJoin + i, lms3dBeamSphere::Right) &&
      lms3dIsWithinTolerance(this->Sphere.GetRange(index),
        plane.GetInverseRange(neighbors.FirstRow + i), this->Tolerance);
    this->Runs.GetOpen()[i] = isOpen ? 1 : 0;
  }
}

// The same without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
void lms3dPatchGrower::MarkOpenOfRegular(const Neighbors& neighbors, lms3dColumnPlane plane)
{
  const std::int32_t* const labels = this->Result.Labels.data() + neighbors.First;
  const double* const ranges = this->Sphere.GetRanges() + neighbors.First;
  const std::uint8_t* const joins = this->Sphere.GetJoins() + neighbors.FirstJoin;
  std::int32_t* const isOpen = this->Runs.GetOpen();
  const double tolerance = this->Tolerance;
  const int row = neighbors.FirstRow;
  const int count = neighbors.Count;
  for (int i = 0; i < count; ++i)
  {
    const bool fits =
      lms3dIsWithinTolerance(ranges[i], plane.GetInverseRangeOfRegular(row + i), tolerance);
    isOpen[i] =
      fits & ((joins[i] & lms3dBeamSphere::JoinedRight) != 0) & (labels[i] == lms3dPatches::Free)
      ? 1
      : 0;
  }
}

bool lms3dPatchGrower::Fits(GridIndex index, const lms3dPlane& plane) const
{
  return lms3dIsWithinTolerance(this->Sphere.GetRange(index),
    plane.GetInverseRange(this->Sphere.GetDirection(index)), this->Tolerance);
}
