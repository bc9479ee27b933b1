// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dSurfaceFit.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace
{
// A beam with at least this share of a vertex determines its range.
constexpr double DeterminingShare = 0.3;
constexpr int Rounds = 4;
// The number of triangles that a thread takes at least.
constexpr std::size_t TrianglesOfTask = 8;
} // namespace

lms3dSurfaceFit::lms3dSurfaceFit(const lms3dBeamDemands& demands,
  const lms3dBorderShortcuts& borders, double maximumError, std::vector<std::uint8_t> isChosen,
  lms3dVertexStars& stars)
  : Demands(demands)
  , Borders(borders)
  , MaximumError(maximumError)
  , Stars(stars)
  , Beams(stars.GetTriangles().size())
  , Sums(stars.GetTriangles().size())
  , MayBeSteps(stars.GetTriangles().size(), AllCorners)
  , Before(stars.GetNumberOfVertices())
  , IsMovable(std::move(isChosen))
  , MovesBack(stars.GetNumberOfVertices())
{
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    this->Before[vertex] = stars.GetVertex(vertex).Inverse;
  }
  this->Inverses = this->Before;
}

void lms3dSurfaceFit::Run()
{
  this->AddUpTriangles();
  this->FindMovable();
  this->Minimize();
  this->ForgetSmallMoves();
  this->MoveForbiddenBack();
  if (this->GetSum(this->Inverses) < this->GetSum(this->Before))
  {
    this->MoveVertices();
  }
}

void lms3dSurfaceFit::AddUpTriangles()
{
  lms3dForEachInTasks(this->Sums.size(), TrianglesOfTask,
    [this](std::size_t i)
    {
      const lms3dVertexStars::Triangle& triangle = this->Stars.GetTriangles()[i];
      if (!triangle.IsRemoved &&
        std::any_of(triangle.Corners.begin(), triangle.Corners.end(),
          [this](std::int32_t corner) { return this->IsMovable[corner] != 0; }))
      {
        this->Beams[i] = this->FindBeams(i);
        this->Sums[i] = lms3dTriangleSums(this->Demands, this->Beams[i], this->GetInverses(i));
      }
    });
}

lms3dTriangleBeams lms3dSurfaceFit::FindBeams(std::size_t triangle) const
{
  const auto& [a, b, c] = this->Stars.GetTriangles()[triangle].Corners;
  return { this->Demands.GetSphere(),
    { &this->Stars.GetVertex(a).Corner, &this->Stars.GetVertex(b).Corner,
      &this->Stars.GetVertex(c).Corner } };
}

std::array<double, 3> lms3dSurfaceFit::GetInverses(std::size_t triangle) const
{
  const auto& [a, b, c] = this->Stars.GetTriangles()[triangle].Corners;
  return { this->Inverses[a], this->Inverses[b], this->Inverses[c] };
}

void lms3dSurfaceFit::FindMovable()
{
  std::vector<std::uint8_t> isDetermined(this->IsMovable.size());
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    const Corners& corners = this->Stars.GetTriangles()[i].Corners;
    for (int corner = 0; corner < 3; ++corner)
    {
      isDetermined[corners[corner]] |=
        this->Sums[i].GetLargestShare(corner) >= DeterminingShare ? 1 : 0;
    }
  }
  for (std::size_t vertex = 0; vertex < isDetermined.size(); ++vertex)
  {
    this->IsMovable[vertex] &= isDetermined[vertex];
  }
}

void lms3dSurfaceFit::Minimize()
{
  for (int round = 0; round < Rounds; ++round)
  {
    for (std::int32_t vertex = 0; vertex < this->Stars.GetNumberOfVertices(); ++vertex)
    {
      if (this->IsMovable[vertex])
      {
        const double best = this->GetBest(vertex);
        this->Inverses[vertex] = best > 0.0 ? best : this->Before[vertex];
      }
    }
  }
}

// The best inverse range of a vertex while its neighbours stay.
double lms3dSurfaceFit::GetBest(std::int32_t vertex) const
{
  double product = 0.0;
  double square = 0.0;
  for (std::int32_t number : this->Stars.GetVertex(vertex).Triangles)
  {
    const lms3dTriangleSums& sums = this->Sums[number];
    const Corners& corners = this->Stars.GetTriangles()[number].Corners;
    const int own = corners[0] == vertex ? 0 : (corners[1] == vertex ? 1 : 2);
    const int next = (own + 1) % 3;
    const int last = (own + 2) % 3;
    square += sums.GetSquare(own, own);
    product += sums.GetProduct(own) - sums.GetSquare(own, next) * this->Inverses[corners[next]] -
      sums.GetSquare(own, last) * this->Inverses[corners[last]];
  }
  return product / square;
}
