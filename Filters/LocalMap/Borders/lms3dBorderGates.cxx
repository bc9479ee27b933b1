// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderGates.h"

#include "LocalMap/Patches/lms3dLabelChanges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace
{
// If the cosine between two beams is below this, borders stay near the middle of their gate. A
// patch could reach behind the sensor otherwise.
constexpr double WideCosine = 0.6;
constexpr double WideMargin = 0.45;
// Two planes count as parallel if their difference changes by less than this share of the limit.
constexpr double ParallelShare = 1e-6;
// The number of columns whose gates a task finds.
constexpr int ColumnsOfPart = 8;
} // namespace

lms3dBorderGates::lms3dBorderGates(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance)
  : Sphere(sphere)
  , Patches(patches)
  , Tolerance(tolerance)
{
  this->FindGates();
  this->LinkEdges();
}

void lms3dBorderGates::FindGates()
{
  this->GateOf.assign(2 * static_cast<std::size_t>(this->Sphere.GetSize()), NoGate);
  const int columns = this->Sphere.GetNumberOfColumns();
  std::vector<std::vector<Gate>> ofParts((columns + ColumnsOfPart - 1) / ColumnsOfPart);
  tbb::parallel_for(0, static_cast<int>(ofParts.size()),
    [&](int part)
    {
      lms3dLabelChanges changes(this->Sphere, this->Patches.Labels);
      const int end = std::min(columns, (part + 1) * ColumnsOfPart);
      for (int column = part * ColumnsOfPart; column < end; ++column)
      {
        this->AppendGates(column, changes, ofParts[part]);
      }
    });
  const auto add = [](std::size_t sum, const auto& ofPart) { return sum + ofPart.size(); };
  this->Gates.reserve(std::accumulate(ofParts.begin(), ofParts.end(), std::size_t(0), add));
  for (const std::vector<Gate>& ofPart : ofParts)
  {
    for (const Gate& gate : ofPart)
    {
      const int side =
        gate.Ends[1] == gate.Ends[0] + 1 ? lms3dBeamSphere::Up : lms3dBeamSphere::Right;
      this->GateOf[2 * static_cast<std::size_t>(gate.Ends[0]) + side] =
        static_cast<std::int32_t>(this->Gates.size());
      this->Gates.push_back(gate);
    }
  }
}

// The gates in a column, and between it and the next one.
// A depth step can end inside a patch, as a slit.
void lms3dBorderGates::AppendGates(
  int column, lms3dLabelChanges& changes, std::vector<Gate>& gates) const
{
  changes.ForEach(column, lms3dLabelChanges::GateUp | lms3dLabelChanges::GateRight,
    [&](GridIndex index, int found)
    {
      if (found & lms3dLabelChanges::GateUp)
      {
        gates.push_back(this->MakeGate(index, lms3dBeamSphere::Up));
      }
      if (found & lms3dLabelChanges::GateRight)
      {
        gates.push_back(this->MakeGate(index, lms3dBeamSphere::Right));
      }
    });
}

double lms3dBorderGates::GetMargin(GridIndex index, int side) const
{
  const GridIndex other = this->Sphere.GetNeighbor(index, side);
  const bool isOneSurface = this->Patches.Labels[index] >= 0 && this->Patches.Labels[other] >= 0 &&
    this->Sphere.IsJoined(index, side);
  return isOneSurface || !this->Sphere.IsRegular() ? Margin : DepthStepMargin;
}

lms3dBorderGates::Gate lms3dBorderGates::MakeGate(GridIndex index, int side) const
{
  const GridIndex other = this->Sphere.GetNeighbor(index, side);
  const bool isWide =
    lms3dDot(this->Sphere.GetDirection(index), this->Sphere.GetDirection(other)) < WideCosine;
  const double margin = isWide ? WideMargin : this->GetMargin(index, side);
  Gate gate = { { index, other }, DepthStep, margin, 1.0 - margin, 0.5 };
  // A return with a facet of its own belongs to no patch.
  if (this->Patches.Labels[index] >= 0 && this->Patches.Labels[other] >= 0 &&
    this->Sphere.IsJoined(index, side))
  {
    this->Classify(gate);
  }
  return gate;
}

// Along the chord of a gate, the inverse ranges of both planes are linear, and so is their
// difference. The gate is a crease if the difference is within the tolerance somewhere. It is best
// where it is 0.
void lms3dBorderGates::Classify(Gate& gate) const
{
  std::array<double, 2> differences;
  double limit = this->Tolerance;
  for (int end = 0; end < 2; ++end)
  {
    const lms3dVector direction = this->Sphere.GetDirection(gate.Ends[end]);
    const auto inverse = [&](int i)
    {
      const int patch = this->Patches.Labels[gate.Ends[i]];
      return this->Patches.Patches[patch].Plane.GetInverseRange(direction);
    };
    differences[end] = inverse(0) - inverse(1);
    limit /= this->Sphere.GetRange(gate.Ends[end]);
  }
  gate.Kind = Offset;
  const double slope = differences[1] - differences[0];
  if (std::abs(slope) <= limit * ParallelShare)
  {
    gate.Kind = std::abs(differences[0]) <= limit ? Crease : Offset;
    return;
  }
  const double center = -differences[0] / slope;
  const double halfWidth = limit / std::abs(slope);
  const double low = std::max(CreaseMargin, center - halfWidth);
  const double high = std::min(1.0 - CreaseMargin, center + halfWidth);
  if (low > high && this->HasFewReturns(this->Patches.Labels[gate.Ends[0]]) &&
    this->HasFewReturns(this->Patches.Labels[gate.Ends[1]]))
  {
    gate.Kind = Crease;
    return;
  }
  // Wide gates keep their margin.
  if (low <= high && gate.Low < WideMargin)
  {
    gate = { gate.Ends, Crease, low, high, std::min(high, std::max(low, center)) };
  }
}

void lms3dBorderGates::LinkEdges()
{
  this->Next.assign(this->GetNumberOfEdges(), NoGate);
  tbb::parallel_for(0, this->GetNumberOfEdges(),
    [this](int edge) { this->Next[edge] = this->IsVoid(edge) ? NoGate : this->FindNext(edge); });
}

int lms3dBorderGates::GetSide(int edge) const
{
  const int gate = edge / 2;
  const GridIndex first = this->Gates[gate].Ends[0];
  const bool isUp = this->GateOf[2 * static_cast<std::size_t>(first)] == gate;
  const int side = isUp ? lms3dBeamSphere::Up : lms3dBeamSphere::Right;
  return (edge & 1) ? (side + 2) % 4 : side;
}

// The edge on one side of a beam, or NoGate.
int lms3dBorderGates::GetEdge(GridIndex index, int side) const
{
  const bool isSecond = side == lms3dBeamSphere::Down || side == lms3dBeamSphere::Left;
  const GridIndex first = isSecond ? this->Sphere.GetNeighbor(index, side) : index;
  const int gate = this->GateOf[2 * static_cast<std::size_t>(first) + side % 2];
  return gate == NoGate ? NoGate : 2 * gate + (isSecond ? 1 : 0);
}

// With the patch to its left, the border on the upper side of a beam heads left, the border on the
// left side heads down, and so on. In the next cell, it turns around the first beam that is not in
// the patch.
int lms3dBorderGates::FindNext(int edge) const
{
  const int side = this->GetSide(edge);
  const int heading = (side + 3) % 4;
  GridIndex index = this->GetOwner(edge);
  for (int turned : { heading, side, (side + 1) % 4, (side + 2) % 4 })
  {
    const int next = this->GetEdge(index, turned);
    if (next != NoGate)
    {
      return next;
    }
    index = this->Sphere.GetNeighbor(index, turned);
  }
  return NoGate;
}

bool lms3dBorderGates::IsRegular(int edge) const
{
  const int next = this->Next[edge];
  const GateKind kind = this->GetGate(edge).Kind;
  // At the end of a slit, the border turns back to its own twin.
  return this->GetGate(next).Kind == kind && next != GetTwin(edge) &&
    (kind == DepthStep || this->Next[GetTwin(next)] == GetTwin(edge));
}

lms3dBorderGates::Cell lms3dBorderGates::GetCell(GridIndex lowerLeft) const
{
  const GridIndex upperLeft = this->Sphere.GetNeighbor(lowerLeft, lms3dBeamSphere::Up);
  return { lowerLeft,
    { lowerLeft, upperLeft, this->Sphere.GetNeighbor(upperLeft, lms3dBeamSphere::Right),
      this->Sphere.GetNeighbor(lowerLeft, lms3dBeamSphere::Right) } };
}

lms3dBorderGates::Cell lms3dBorderGates::GetEndCell(int edge, int& corner) const
{
  const int side = this->GetSide(edge);
  GridIndex index = this->GetOwner(edge);
  // The edge ends in the cell to the upper left of its owner, or upper right, lower right, lower
  // left.
  corner = (side + 3) % 4;
  if (corner == 1 || corner == 2)
  {
    index = this->Sphere.GetNeighbor(index, lms3dBeamSphere::Down);
  }
  if (corner == 2 || corner == 3)
  {
    index = this->Sphere.GetNeighbor(index, lms3dBeamSphere::Left);
  }
  return this->GetCell(index);
}

int lms3dBorderGates::GetCellGate(const Cell& cell, int corner) const
{
  constexpr int First[4] = { 0, 1, 3, 0 };
  const GridIndex first = cell.Corners[First[corner]];
  return this->GateOf[2 * static_cast<std::size_t>(first) + (corner % 2)];
}

bool lms3dBorderGates::IsContinuous(const Cell& cell) const
{
  for (int corner = 0; corner < 4; ++corner)
  {
    if (this->Patches.Labels[cell.Corners[corner]] < 0 ||
      this->HasCellGate(cell, corner, DepthStep))
    {
      return false;
    }
  }
  return true;
}
