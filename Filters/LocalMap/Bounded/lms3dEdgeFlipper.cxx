// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dEdgeFlipper.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dTriangleBeams.h"
#include "LocalMap/Bounded/lms3dTriangleOfDirections.h"

#include <algorithm>
#include <cmath>

namespace
{
// How far the surface must move where the diagonals cross, in bounds. Smaller moves do not pay, and
// larger ones leave the bound of a return.
constexpr double SmallestChange = 0.1;
constexpr double LargestChange = 2.0;
// The sum of squares after a flip, as a share of that before.
constexpr double LargestShare = 0.95;
// The smallest height of a new triangle as the sensor sees it, as a share of its longest edge.
// Triangles may be as flat as those that they replace.
constexpr double MinimumHeight = 0.02;
// If edges have collapsed at a smaller share of the triangles, most of the surface is flat, and
// flips hardly pay.
constexpr double SmallestCurvedShare = 0.25;
// The number of triangles that a thread looks at at least.
constexpr std::size_t TrianglesOfTask = 16;

/// A triangle of the map, and its beams. The corner with the smallest number comes first, so that
/// equal triangles have equal sums.
class Face
{
public:
  Face(const lms3dBeamDemands& demands, const lms3dVertexStars& stars,
    std::array<std::int32_t, 3> corners)
    : Demands(demands)
  {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const auto& [a, b, c] = corners;
    this->Inverses = { stars.GetVertex(a).Inverse, stars.GetVertex(b).Inverse,
      stars.GetVertex(c).Inverse };
    this->Beams = lms3dTriangleBeams(demands.GetSphere(),
      { &stars.GetVertex(a).Corner, &stars.GetVertex(b).Corner, &stars.GetVertex(c).Corner });
  }

  bool IsWithinBound() const { return this->Beams.AreWithinBound(this->Demands, this->Inverses); }
  double GetSum() const { return this->Beams.GetSum(this->Demands, this->Inverses); }

private:
  const lms3dBeamDemands& Demands;
  std::array<double, 3> Inverses;
  lms3dTriangleBeams Beams;
};
} // namespace

lms3dEdgeFlipper::lms3dEdgeFlipper(const lms3dBeamDemands& demands,
  const std::vector<std::int32_t>& patchIds, double maximumError, lms3dVertexStars& stars)
  : Demands(demands)
  , PatchIds(patchIds)
  , MaximumError(maximumError)
  , Stars(stars)
  , IsChanged(stars.GetTriangles().size())
{
  std::size_t count = 0;
  const auto hasChanged = [&](std::int32_t corner) { return stars.GetVertex(corner).IsChanged; };
  for (std::size_t i = 0; i < stars.GetTriangles().size(); ++i)
  {
    const lms3dVertexStars::Triangle& triangle = stars.GetTriangles()[i];
    count += triangle.IsRemoved ? 0U : 1U;
    if (!triangle.IsRemoved && !triangle.IsStrip &&
      std::any_of(triangle.Corners.begin(), triangle.Corners.end(), hasChanged))
    {
      this->MarkChanged(static_cast<std::int32_t>(i));
    }
  }
  if (static_cast<double>(this->Changed.size()) < SmallestCurvedShare * static_cast<double>(count))
  {
    this->Changed.clear();
  }
}

std::vector<std::uint8_t> lms3dEdgeFlipper::Run()
{
  std::vector<std::uint8_t> isAtFlip;
  while (this->MakeFlips(this->FindFlips(), isAtFlip))
  {
  }
  this->AddNeighbors(isAtFlip);
  return isAtFlip;
}

void lms3dEdgeFlipper::AddNeighbors(std::vector<std::uint8_t>& isChosen) const
{
  const std::vector<std::uint8_t> before = isChosen;
  for (std::size_t vertex = 0; vertex < before.size(); ++vertex)
  {
    if (before[vertex])
    {
      for (std::int32_t neighbor : this->Stars.GetNeighbors(static_cast<std::int32_t>(vertex)))
      {
        isChosen[neighbor] = 1;
      }
    }
  }
}

std::vector<lms3dEdgeFlipper::Flip> lms3dEdgeFlipper::FindFlips() const
{
  std::vector<Flip> flips(this->Changed.size());
  lms3dForEachInTasks(flips.size(), TrianglesOfTask,
    [&](std::size_t i) { flips[i] = this->FindBestFlip(this->Changed[i]); });
  flips.erase(
    std::remove_if(flips.begin(), flips.end(), [](const Flip& flip) { return !(flip.Gain > 0.0); }),
    flips.end());
  std::sort(flips.begin(), flips.end(),
    [](const Flip& a, const Flip& b)
    { return a.Gain != b.Gain ? a.Gain > b.Gain : a.Edge.LeftTriangle < b.Edge.LeftTriangle; });
  return flips;
}

lms3dEdgeFlipper::Flip lms3dEdgeFlipper::FindBestFlip(std::int32_t triangle) const
{
  Flip best;
  for (int corner = 0; corner < 3; ++corner)
  {
    Quad quad;
    if (this->FindQuad(triangle, corner, quad) && this->CanFlip(quad))
    {
      const double gain = this->GetGain(quad);
      best = gain > best.Gain ? Flip{ gain, quad } : best;
    }
  }
  return best;
}

// Finds the quadrilateral around the edge from a corner to the next. Returns false if the edge does
// not belong to two triangles, or if the other triangle finds it.
bool lms3dEdgeFlipper::FindQuad(std::int32_t triangle, int corner, Quad& quad) const
{
  const std::array<std::int32_t, 3>& corners = this->Stars.GetTriangles()[triangle].Corners;
  quad = { triangle, -1, corners[corner], corners[(corner + 1) % 3], corners[(corner + 2) % 3],
    -1 };
  int others = 0;
  this->Stars.ForEachTriangle(quad.From,
    [&](std::int32_t number, std::int32_t next, std::int32_t last)
    {
      if (last == quad.To)
      {
        quad.RightTriangle = number;
        quad.Right = next;
        ++others;
      }
      return true;
    });
  return others == 1 && !this->Stars.GetTriangles()[quad.RightTriangle].IsStrip &&
    this->PatchIds[triangle] == this->PatchIds[quad.RightTriangle] &&
    (quad.From < quad.To || !this->IsChanged[quad.RightTriangle]);
}

// Decides without beams whether a flip can gain.
bool lms3dEdgeFlipper::CanFlip(const Quad& quad) const
{
  const double change = this->GetChange(quad) / this->MaximumError;
  const lms3dVector& from = this->GetDirection(quad.From);
  const lms3dVector& to = this->GetDirection(quad.To);
  const lms3dVector& left = this->GetDirection(quad.Left);
  const lms3dVector& right = this->GetDirection(quad.Right);
  const double height = std::min(
    { MinimumHeight, lms3dGetHeightShare(from, to, left), lms3dGetHeightShare(to, from, right) });
  return change > SmallestChange && change < LargestChange &&
    lms3dGetHeightShare(left, from, right) >= height &&
    lms3dGetHeightShare(right, to, left) >= height && !this->AreNeighbors(quad.Left, quad.Right);
}

bool lms3dEdgeFlipper::AreNeighbors(std::int32_t a, std::int32_t b) const
{
  return !this->Stars.ForEachTriangle(
    a, [b](std::int32_t, std::int32_t next, std::int32_t last) { return next != b && last != b; });
}

// How far the surface moves where the sensor sees the diagonals cross, metres. 0 if they do not.
// With right = a from + b to + c left, they cross in the direction of a from + b to. Inverse ranges
// times the lengths of directions are linear on each of the diagonals.
double lms3dEdgeFlipper::GetChange(const Quad& quad) const
{
  const lms3dVector& from = this->GetDirection(quad.From);
  const lms3dVector& to = this->GetDirection(quad.To);
  const lms3dVector& left = this->GetDirection(quad.Left);
  const lms3dVector& right = this->GetDirection(quad.Right);
  const auto getInverse = [this](std::int32_t vertex)
  { return this->Stars.GetVertex(vertex).Inverse; };
  const double turn = lms3dGetTurn(from, to, left);
  const double a = lms3dGetTurn(right, to, left) / turn;
  const double b = lms3dGetTurn(from, right, left) / turn;
  const double c = lms3dGetTurn(from, to, right) / turn;
  if (!(a > 0.0 && b > 0.0 && c < 0.0))
  {
    return 0.0;
  }
  const double length = lms3dGetLength(lms3dAdd(lms3dScale(from, a), lms3dScale(to, b)));
  const double before = a * getInverse(quad.From) + b * getInverse(quad.To);
  const double after = getInverse(quad.Right) - c * getInverse(quad.Left);
  return length * std::abs(1.0 / after - 1.0 / before);
}

// 0 if a return would leave the bound, or if too little is gained.
double lms3dEdgeFlipper::GetGain(const Quad& quad) const
{
  const Face atFrom(this->Demands, this->Stars, { quad.Left, quad.From, quad.Right });
  const Face atTo(this->Demands, this->Stars, { quad.Right, quad.To, quad.Left });
  if (!atFrom.IsWithinBound() || !atTo.IsWithinBound())
  {
    return 0.0;
  }
  const double after = atFrom.GetSum() + atTo.GetSum();
  const double before =
    Face(this->Demands, this->Stars, { quad.From, quad.To, quad.Left }).GetSum() +
    Face(this->Demands, this->Stars, { quad.To, quad.From, quad.Right }).GetSum();
  return after < LargestShare * before ? before - after : 0.0;
}

// Returns false if there are none. An earlier flip may have joined the same two vertices.
bool lms3dEdgeFlipper::MakeFlips(
  const std::vector<Flip>& flips, std::vector<std::uint8_t>& isAtFlip)
{
  for (std::int32_t triangle : this->Changed)
  {
    this->IsChanged[triangle] = 0;
  }
  this->Changed.clear();
  for (const Flip& flip : flips)
  {
    const Quad& quad = flip.Edge;
    if (this->IsChanged[quad.LeftTriangle] || this->IsChanged[quad.RightTriangle] ||
      this->AreNeighbors(quad.Left, quad.Right))
    {
      continue;
    }
    this->Stars.Flip(quad);
    this->MarkChanged(quad.LeftTriangle);
    this->MarkChanged(quad.RightTriangle);
    isAtFlip.resize(this->Stars.GetNumberOfVertices());
    for (std::int32_t corner : { quad.From, quad.To, quad.Left, quad.Right })
    {
      isAtFlip[corner] = 1;
    }
  }
  return !flips.empty();
}
