// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dJunctionPlacement.h"

#include "LocalMap/Borders/lms3dCreaseIntersection.h"

namespace
{
// The cosine of a diagonal of the widest cell in which junctions move.
constexpr double WideCosine = 0.6;
// How far the junctions of one cell stand from its middle, as a share of the cell.
constexpr double Separation = 0.06;

// From the middle of a cell towards the center of some of its corners.
lms3dPoint2 GetOffset(int corners)
{
  constexpr double X[4] = { -1.0, -1.0, 1.0, 1.0 };
  constexpr double Y[4] = { -1.0, 1.0, 1.0, -1.0 };
  lms3dPoint2 offset = { 0.0, 0.0 };
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (corners >> i & 1)
    {
      offset[0] += Separation * X[i];
      offset[1] += Separation * Y[i];
      ++count;
    }
  }
  return { offset[0] / count, offset[1] / count };
}
} // namespace

lms3dMapVertex lms3dJunctionPlacement::Locate(
  const Cell& cell, int corners, bool staysInMiddle) const
{
  return this->BorderRanges.GetVertexInCell(
    cell, corners, this->FindWeights(cell, corners, staysInMiddle));
}

std::array<double, 4> lms3dJunctionPlacement::FindWeights(
  const Cell& cell, int corners, bool staysInMiddle) const
{
  bool hasOffset = false;
  for (int i = 0; i < 4; ++i)
  {
    hasOffset |= this->Gates.HasCellGate(cell, i, lms3dBorderGates::Offset);
  }
  lms3dCreaseIntersection point;
  for (int i = 0; i < 4; ++i)
  {
    if (this->Gates.HasCellGate(cell, i, lms3dBorderGates::Crease) &&
      (hasOffset || (corners >> i & 1)))
    {
      point.AddCrease(this->GetDifferences(cell, i));
    }
  }
  const lms3dPoint2 offset = GetOffset(corners);
  if (!hasOffset)
  {
    point.Move(offset);
  }
  if (!staysInMiddle && !this->IsWide(cell))
  {
    point.Solve();
  }
  if (hasOffset)
  {
    point.Move(offset);
  }
  return point.GetWeights();
}

// The difference between the planes on both sides of one gate of a cell, at the cell's corners.
std::array<double, 4> lms3dJunctionPlacement::GetDifferences(const Cell& cell, int corner) const
{
  const auto getPlane = [&](int i) -> const lms3dVector&
  { return this->Patches.Patches[this->Patches.Labels[cell.Corners[i]]].Plane.Q; };
  const lms3dVector difference = lms3dSubtract(getPlane(corner), getPlane((corner + 1) % 4));
  std::array<double, 4> differences;
  for (int i = 0; i < 4; ++i)
  {
    differences[i] = lms3dDot(difference, this->Sphere.GetDirection(cell.Corners[i]));
  }
  return differences;
}

// In a wide cell, a junction that moves could come far from the returns.
bool lms3dJunctionPlacement::IsWide(const Cell& cell) const
{
  const auto getCosine = [&](int a, int b)
  {
    return lms3dDot(
      this->Sphere.GetDirection(cell.Corners[a]), this->Sphere.GetDirection(cell.Corners[b]));
  };
  return getCosine(0, 2) < WideCosine || getCosine(1, 3) < WideCosine;
}
