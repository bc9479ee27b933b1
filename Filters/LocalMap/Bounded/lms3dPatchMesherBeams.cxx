// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dColumnDeviations.h"
#include "LocalMap/Bounded/lms3dPatchMesher.h"
#include "LocalMap/Bounded/lms3dPatchMesherWork.h"

#include <cmath>

namespace
{
// Without branches, so that the compiler makes it a loop over vectors.
bool AreAll(const std::int32_t* first, const std::int32_t* end, std::int32_t value)
{
  std::int32_t difference = 0;
  for (const std::int32_t* label = first; label != end; ++label)
  {
    difference |= *label ^ value;
  }
  return difference == 0;
}
} // namespace

// Returns false if a beam of another patch hits the triangle.
bool lms3dPatchMesher::CheckTriangle(Work& work, int triangle)
{
  const std::array<std::int32_t, 3>& corners = work.Triangulation.GetCorners(triangle);
  const lms3dTriangleRasterizer beams(this->Sphere, work.Triangulation.GetVertex(corners[0]),
    work.Triangulation.GetVertex(corners[1]), work.Triangulation.GetVertex(corners[2]));
  return beams.ForEachColumnWhile([&](int column, int first, int last)
    { return this->CheckBeams(work, triangle, beams, column, first, last); });
}

bool lms3dPatchMesher::CheckBeams(
  Work& work, int triangle, const lms3dTriangleRasterizer& beams, int column, int first, int last)
{
  const bool isRegular = this->Sphere.IsRegular();
  const bool hasFilled = this->Sphere.HasFilled();
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const std::int32_t* const labels = this->Patches.Labels.data() + start;
  const auto isOwn = [patch = work.Patch](std::int32_t label) { return label == patch; };
  if (isRegular && !AreAll(labels + first, labels + last + 1, work.Patch))
  {
    return false;
  }
  const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
  if (isRegular && this->TryToCoverBeams(work, hits, column, first, last))
  {
    return true;
  }
  const double maximumError = this->MaximumError;
  State* const states = this->States.data() + start;
  int covered = 0;
  for (int row = first; row <= last; ++row)
  {
    if ((!isRegular && !isOwn(labels[row])) || (column > 0 && this->Sphere.IsPoleRow(row)))
    {
      continue;
    }
    const bool isFilled = hasFilled && this->Sphere.IsFilled(start + row);
    covered += states[row] == IsUncovered && !isFilled ? 1 : 0;
    states[row] = states[row] == IsUncovered ? IsCovered : states[row];
    const double hit = hits.GetRange(row);
    const double deviation = std::abs(this->Sphere.GetRangeOnBeam(start + row) - hit) +
      this->Sphere.GetPoleHalfSpread(row);
    if (!(deviation <= maximumError) && states[row] != IsVertex)
    {
      work.AddViolation({ start + row, triangle, hit, deviation });
    }
  }
  work.Covered += covered;
  return true;
}

// Does the same as CheckBeams() for beams that hit within the bound, and is faster. Returns false,
// and changes nothing, if one does not, or if rounding could hide it.
bool lms3dPatchMesher::TryToCoverBeams(
  Work& work, const lms3dTriangleRasterizer::ColumnRanges& hits, int column, int first, int last)
{
  const bool hasPoleCopy =
    column > 0 && (this->Sphere.IsPoleRow(first) || this->Sphere.IsPoleRow(last));
  if (hasPoleCopy ||
    !lms3dAreWithin(this->Sphere, hits.GetPlane(), column, first, last, this->MaximumError))
  {
    return false;
  }
  work.Covered += this->CoverBeams(this->Sphere.GetIndex(column, first), last - first + 1);
  return true;
}

// Returns how many of consecutive entries were uncovered, without filled ones.
int lms3dPatchMesher::CoverBeams(GridIndex first, int count)
{
  State* const states = this->States.data() + first;
  int covered = 0;
  if (this->Sphere.HasFilled())
  {
    const std::uint8_t* const filled = this->Sphere.GetFilled() + first;
    for (int i = 0; i < count; ++i)
    {
      covered -= states[i] == IsUncovered ? filled[i] : 0;
    }
  }
  for (int i = 0; i < count; ++i)
  {
    covered += states[i] == IsUncovered ? 1 : 0;
    states[i] = states[i] == IsUncovered ? IsCovered : states[i];
  }
  return covered;
}
