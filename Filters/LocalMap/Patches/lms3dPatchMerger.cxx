// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchMerger.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace
{
// If the ratio of the returns exceeds this, the larger patch keeps its plane.
constexpr double MuchLargerRatio = 16.0;
constexpr int MaximumPasses = 4;
// The number of labels that a thread writes at least.
constexpr std::size_t LabelsOfTask = 16384;
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

std::vector<lms3dPatchMerger::Pair> lms3dPatchMerger::FindNeighbors() const
{
  const int columns = this->Sphere.GetNumberOfColumns();
  std::vector<std::vector<Pair>> ofColumns(columns);
  tbb::parallel_for(
    0, columns, [&](int column) { this->AppendNeighbors(column, ofColumns[column]); });
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& ofColumn : ofColumns)
  {
    pairs.insert(pairs.end(), ofColumn.begin(), ofColumn.end());
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// The pairs in a column, and between it and the next one.
void lms3dPatchMerger::AppendNeighbors(int column, std::vector<Pair>& pairs) const
{
  const int rows = this->Sphere.GetNumberOfRows();
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const std::int32_t* const labels = this->Patches.Labels.data() + start;
  const std::int32_t* const toRight =
    this->Patches.Labels.data() + this->Sphere.GetNeighbor(start, lms3dBeamSphere::Right);
  const auto add = [&](int row, std::int32_t other, int side)
  {
    if (labels[row] != other && this->Sphere.IsJoined(start + row, side))
    {
      // Along a border, the same pair repeats.
      const Pair pair = { std::min(labels[row], other), std::max(labels[row], other) };
      if (pairs.empty() || pairs.back() != pair)
      {
        pairs.push_back(pair);
      }
    }
  };
  for (int row = 0; row < rows; ++row)
  {
    add(row, toRight[row], lms3dBeamSphere::Right);
    if (row + 1 < rows)
    {
      add(row, labels[row + 1], lms3dBeamSphere::Up);
    }
  }
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
  this->WriteLabels();
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
      const GridIndex start = this->Sphere.GetIndex(column, 0);
      const lms3dColumnPlane inColumn(plane, this->Sphere, column);
      for (GridIndex index = span.First; index <= span.Last; ++index)
      {
        const int row = index - start;
        if (!lms3dIsWithinTolerance(
              this->Sphere.GetRange(index), inColumn.GetInverseRange(row), this->Tolerance))
        {
          return false;
        }
      }
      return true;
    });
}

void lms3dPatchMerger::Join(int large, int small, const lms3dPlane& plane)
{
  lms3dPatches::Patch& a = this->Patches.Patches[large];
  lms3dPatches::Patch& b = this->Patches.Patches[small];
  a.Plane = plane;
  a.Fit.Add(b.Fit);
  a.Spans.insert(a.Spans.end(), b.Spans.begin(), b.Spans.end());
  b.Spans.clear();
  this->Parents[small] = large;
}

void lms3dPatchMerger::WriteLabels()
{
  std::vector<std::int32_t> roots(this->Parents.size());
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    roots[i] = this->FindRoot(static_cast<int>(i));
  }
  lms3dBeamVector<std::int32_t>& labels = this->Patches.Labels;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, labels.size(), LabelsOfTask),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        labels[i] = labels[i] < 0 ? labels[i] : roots[labels[i]];
      }
    });
}
