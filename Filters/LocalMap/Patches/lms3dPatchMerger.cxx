// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchMerger.h"

#include "Geometry/lms3dWideLoops.h"
#include "LocalMap/Patches/lms3dLabelChanges.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace
{
// If the ratio of the returns exceeds this, the larger patch keeps its plane.
constexpr double MuchLargerRatio = 16.0;
constexpr int MaximumPasses = 4;
} // namespace

lms3dPatchMerger::lms3dPatchMerger(
  const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError)
  : Sphere(sphere)
  , Patches(patches)
  , Tolerance(lms3dPatches::MergedShare * maximumError)
  , Parents(patches.Patches.size())
{
  std::iota(this->Parents.begin(), this->Parents.end(), 0);
}

// The pairs in the columns, and between each and the next one.
std::vector<lms3dPatchMerger::Pair> lms3dPatchMerger::FindNeighbors() const
{
  const std::int32_t* const labels = this->Patches.Labels.data();
  tbb::enumerable_thread_specific<std::vector<Pair>> ofThreads;
  const auto findInColumns = [&](const tbb::blocked_range<int>& columns)
  {
    std::vector<Pair>& found = ofThreads.local();
    const auto add = [&](GridIndex index, GridIndex other)
    {
      // Along a border, the same pair repeats.
      const Pair pair = std::minmax(labels[index], labels[other]);
      if (found.empty() || found.back() != pair)
      {
        found.push_back(pair);
      }
    };
    lms3dLabelChanges changes(this->Sphere, this->Patches.Labels);
    for (int column = columns.begin(); column < columns.end(); ++column)
    {
      changes.ForEachBorder(column, add);
    }
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, this->Sphere.GetNumberOfColumns()), findInColumns);
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& ofThread : ofThreads)
  {
    pairs.insert(pairs.end(), ofThread.begin(), ofThread.end());
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

int lms3dPatchMerger::FindRoot(int patch)
{
  while (this->Parents[patch] != patch)
  {
    this->Parents[patch] = this->Parents[this->Parents[patch]];
    patch = this->Parents[patch];
  }
  return patch;
}

void lms3dPatchMerger::Merge()
{
  const std::vector<Pair> pairs = this->FindNeighbors();
  bool hasMerged = true;
  for (int pass = 0; pass < MaximumPasses && hasMerged; ++pass)
  {
    hasMerged = false;
    for (const Pair& pair : pairs)
    {
      int large = this->FindRoot(pair.first);
      int small = this->FindRoot(pair.second);
      const auto size = [&](int patch)
      { return this->Patches.Patches[patch].Fit.GetNumberOfReturns(); };
      if (size(large) < size(small))
      {
        std::swap(large, small);
      }
      hasMerged |= large != small && this->TryToMerge(large, small);
    }
  }
}

bool lms3dPatchMerger::TryToMerge(int large, int small)
{
  const lms3dPatches::Patch& a = this->Patches.Patches[large];
  const lms3dPatches::Patch& b = this->Patches.Patches[small];
  if (this->Explains(a.Plane, b))
  {
    this->Join(large, small, a.Plane);
    return true;
  }
  if (a.Fit.GetNumberOfReturns() > MuchLargerRatio * b.Fit.GetNumberOfReturns())
  {
    return false;
  }
  lms3dPlaneFit fit = a.Fit;
  fit.Add(b.Fit);
  const lms3dPlane plane = fit.GetPlane();
  if (this->Explains(plane, b) && this->Explains(plane, a))
  {
    this->Join(large, small, plane);
    return true;
  }
  return false;
}

bool lms3dPatchMerger::Explains(const lms3dPlane& plane, const lms3dPatches::Patch& patch) const
{
  return std::all_of(patch.Spans.begin(), patch.Spans.end(),
    [&](const lms3dPatches::Span& span)
    {
      const int column = this->Sphere.GetColumn(span.First);
      const lms3dColumnPlane inColumn(plane, this->Sphere, column);
      return this->Sphere.IsRegular() ? this->ExplainsSpanOfRegular(inColumn, span)
                                      : this->ExplainsSpan(inColumn, span);
    });
}

bool lms3dPatchMerger::ExplainsSpan(
  const lms3dColumnPlane& plane, const lms3dPatches::Span& span) const
{
  for (GridIndex index = span.First; index <= span.Last; ++index)
  {
    if (!lms3dIsWithinTolerance(this->Sphere.GetRange(index),
          plane.GetInverseRange(this->Sphere.GetRow(index)), this->Tolerance))
    {
      return false;
    }
  }
  return true;
}

// The same without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
bool lms3dPatchMerger::ExplainsSpanOfRegular(
  const lms3dColumnPlane& plane, const lms3dPatches::Span& span) const
{
  const double* const ranges = this->Sphere.GetRanges() + span.First;
  const int first = this->Sphere.GetRow(span.First);
  const int count = span.Last - span.First + 1;
  const double tolerance = this->Tolerance;
  std::int64_t outside = 0;
  for (int i = 0; i < count; ++i)
  {
    const double inverse = plane.GetInverseRangeOfRegular(first + i);
    outside += lms3dIsWithinTolerance(ranges[i], inverse, tolerance) ? 0 : 1;
  }
  return outside == 0;
}

void lms3dPatchMerger::Join(int large, int small, const lms3dPlane& plane)
{
  lms3dPatches::Patch& a = this->Patches.Patches[large];
  lms3dPatches::Patch& b = this->Patches.Patches[small];
  a.Plane = plane;
  a.Fit.Add(b.Fit);
  for (const lms3dPatches::Span& span : b.Spans)
  {
    std::fill(this->Patches.Labels.begin() + span.First,
      this->Patches.Labels.begin() + span.Last + 1, large);
  }
  a.Spans.insert(a.Spans.end(), b.Spans.begin(), b.Spans.end());
  b.Spans.clear();
  this->Parents[small] = large;
}
