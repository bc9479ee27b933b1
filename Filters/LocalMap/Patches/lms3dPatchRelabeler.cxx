// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPatchRelabeler.h"

#include "LocalMap/Patches/lms3dLabelChanges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// A plane explains returns within this number of standard deviations of the noise.
constexpr double ExplainedDeviations = 4.0;
constexpr int MaximumPasses = 3;
} // namespace

lms3dPatchRelabeler::lms3dPatchRelabeler(
  const lms3dBeamSphere& sphere, lms3dPatches& patches, double maximumError, double noise)
  : Sphere(sphere)
  , Patches(patches)
  , MaximumError(maximumError)
  , Noise(noise)
{
}

double lms3dPatchRelabeler::GetDeviation(GridIndex index, int patch) const
{
  const double inverse =
    this->Patches.Patches[patch].Plane.GetInverseRange(this->Sphere.GetDirection(index));
  return inverse > 0.0 ? std::abs(this->Sphere.GetRange(index) - 1.0 / inverse)
                       : std::numeric_limits<double>::infinity();
}

void lms3dPatchRelabeler::SetLabel(GridIndex index, std::int32_t label)
{
  const int row = this->Sphere.GetRow(index);
  if (!this->Sphere.IsPoleRow(row))
  {
    this->Patches.Labels[index] = label;
    return;
  }
  for (int column = 0; column < this->Sphere.GetNumberOfColumns(); ++column)
  {
    this->Patches.Labels[this->Sphere.GetIndex(column, row)] = label;
  }
}

// The entries on both sides of all borders, sorted.
std::vector<lms3dPatchRelabeler::GridIndex> lms3dPatchRelabeler::FindBorder() const
{
  const GridIndex size = this->Sphere.GetSize();
  // Two threads never write the same mark: one is for entries beside the column on their left.
  std::vector<std::uint8_t> isBorder(size, 0);
  std::vector<std::uint8_t> isRightOfBorder(size, 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, this->Sphere.GetNumberOfColumns()),
    [&](const tbb::blocked_range<int>& columns)
    {
      lms3dLabelChanges changes(this->Sphere, this->Patches.Labels);
      for (int column = columns.begin(); column < columns.end(); ++column)
      {
        changes.ForEachBorder(column,
          [&](GridIndex index, GridIndex other)
          {
            isBorder[index] = 1;
            (other == index + 1 ? isBorder : isRightOfBorder)[other] = 1;
          });
      }
    });
  std::transform(isBorder.begin(), isBorder.end(), isRightOfBorder.begin(), isBorder.begin(),
    [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
  std::vector<GridIndex> border;
  const auto findFrom = [&](GridIndex index)
  { return lms3dLabelChanges::FindFirst(isBorder.data(), index, size, 1); };
  for (GridIndex index = findFrom(0); index < size; index = findFrom(index + 1))
  {
    border.push_back(index);
  }
  return border;
}

void lms3dPatchRelabeler::RelabelBorders()
{
  std::vector<GridIndex> border = this->FindBorder();
  for (int pass = 0; pass < MaximumPasses; ++pass)
  {
    std::vector<GridIndex> moved;
    for (GridIndex index : border)
    {
      if (this->MoveToBestNeighbor(index))
      {
        this->ForEachJoinedNeighbor(index, [&](GridIndex other) { moved.push_back(other); });
      }
    }
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    border = moved;
  }
}

bool lms3dPatchRelabeler::MoveToBestNeighbor(GridIndex index)
{
  const std::int32_t own = this->Patches.Labels[index];
  std::int32_t best = own;
  this->ForEachJoinedNeighbor(index,
    [&](GridIndex other)
    {
      const std::int32_t label = this->Patches.Labels[other];
      if (label != best && label != own && this->IsBetter(index, label, best))
      {
        best = label;
      }
    });
  if (best != own)
  {
    this->SetLabel(index, best);
  }
  return best != own;
}

// If both planes explain a return, the side of their crease decides instead of the noise.
bool lms3dPatchRelabeler::IsBetter(GridIndex index, std::int32_t label, std::int32_t than) const
{
  const double deviation = this->GetDeviation(index, label);
  const double other = this->GetDeviation(index, than);
  const double explained =
    std::max(lms3dPatches::MergedShare * this->MaximumError, ExplainedDeviations * this->Noise);
  if (std::max(deviation, other) <= explained)
  {
    const lms3dPatches::Patch& a = this->Patches.Patches[label];
    const lms3dPatches::Patch& b = this->Patches.Patches[than];
    const lms3dVector across = lms3dSubtract(a.Plane.Q, b.Plane.Q);
    const double sideOfA = lms3dDot(across, a.Fit.GetCenter());
    const double sideOfB = lms3dDot(across, b.Fit.GetCenter());
    const double side = lms3dDot(across, this->Sphere.GetDirection(index));
    if (sideOfA * sideOfB < 0.0)
    {
      return side * sideOfA > 0.0;
    }
  }
  return deviation < other;
}
