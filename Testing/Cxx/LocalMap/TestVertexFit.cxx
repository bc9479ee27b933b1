// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the fit of a vertex with sums over all beams of its triangles.
 */
#include "LocalMap/Bounded/lms3dTriangleBeams.h"
#include "LocalMap/Bounded/lms3dVertexFit.h"
#include "LocalMap/SurfaceFitFixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace
{
/// A ball whose returns have errors. A tenth of the beams have no return, a tenth of the returns no
/// patch, and no beam within 18 degrees of one pole returns.
class VertexFit : public SurfaceFit
{
protected:
  static constexpr double Bound = 0.2;
  /// Many for each column of a triangle.
  static constexpr int ManyBeams = 721;
  static constexpr int BeamsBelowHole = 648;

  /// What the beams around a vertex demand of its inverse range.
  struct Sums
  {
    double Minimum = 0.0;
    double Maximum = std::numeric_limits<double>::infinity();
    double LargestShare = 0.0;
    double Squares = 0.0;
    double Products = 0.0;
    int LargestSpan = 0;
  };

  VertexFit()
    : NoisyScan(
        [this](int beam, int)
        {
          const bool isMissing = beam > BeamsBelowHole || this->IsSpoiled(this->Random);
          return isMissing ? 0.0 : Radius + this->Error(this->Random);
        },
        ManyBeams)
    , NoisySphere(this->NoisyScan.Grid, this->NoisyScan.Joins)
    , Demands(this->NoisySphere, this->MakePatches(), Bound)
    , Map(Radius)
    , Stars(this->Map.Get())
  {
  }

  lms3dPatches MakePatches()
  {
    lms3dPatches patches;
    patches.Patches.resize(1);
    patches.Labels.assign(this->NoisySphere.GetSize(), 0);
    for (std::int32_t& label : patches.Labels)
    {
      label = this->IsSpoiled(this->Random) ? lms3dPatches::None : 0;
    }
    return patches;
  }

  void AddBeams(std::int32_t vertex, std::int32_t next, std::int32_t last, Sums& sums) const
  {
    const lms3dTriangleBeams beams(this->NoisySphere,
      { &this->Stars.GetVertex(vertex).Corner, &this->Stars.GetVertex(next).Corner,
        &this->Stars.GetVertex(last).Corner });
    const lms3dVector rest = beams.GetPlane(
      { 0.0, this->Stars.GetVertex(next).Inverse, this->Stars.GetVertex(last).Inverse });
    for (const lms3dTriangleBeams::Span& span : beams.GetSpans())
    {
      sums.LargestSpan = std::max(sums.LargestSpan, span.Last - span.First + 1);
      for (int row = span.First; row <= span.Last; ++row)
      {
        const lms3dBeamSphere::GridIndex index = this->NoisySphere.GetIndex(span.Column, row);
        const lms3dVector direction = this->NoisySphere.GetDirection(index);
        const double share = lms3dDot(beams.GetShares()[0], direction);
        if (*this->Demands[index].Minimum < 0.0 || share < 1e-9)
        {
          continue;
        }
        const double others = lms3dDot(rest, direction);
        const double range = this->NoisySphere.GetRange(index);
        sums.Minimum = std::max(sums.Minimum, (*this->Demands[index].Minimum - others) / share);
        sums.Maximum = std::min(sums.Maximum, (*this->Demands[index].Maximum - others) / share);
        sums.LargestShare = std::max(sums.LargestShare, share);
        sums.Squares += std::pow(range, 4) * share * share;
        sums.Products += std::pow(range, 4) * share * (1.0 / range - others);
      }
    }
  }

  Sums GetSums(std::int32_t vertex) const
  {
    Sums sums;
    this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        this->AddBeams(vertex, next, last, sums);
        return true;
      });
    return sums;
  }

  /// Returns false if no range satisfies all beams.
  bool AddTriangles(std::int32_t vertex, lms3dVertexFit& fit) const
  {
    return this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        return fit.Add(
          this->Stars.GetVertex(vertex).Corner, lms3dVertexFit::GetSide(this->Stars, next, last));
      });
  }

  bool Allows(std::int32_t vertex, double inverse) const
  {
    return this->Stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        return lms3dVertexFit::Allows(this->Demands, this->Stars.GetVertex(vertex).Corner, inverse,
          lms3dVertexFit::GetSide(this->Stars, next, last));
      });
  }

  std::mt19937 Random{ 3 };
  std::uniform_real_distribution<double> Error{ -0.1, 0.1 };
  std::bernoulli_distribution IsSpoiled{ 0.1 };
  const BallScan NoisyScan;
  const lms3dBeamSphere NoisySphere;
  const lms3dBeamDemands Demands;
  const RoundMap Map;
  const lms3dVertexStars Stars;
};
} // namespace

TEST_F(VertexFit, MinimizesTheSquaresWithinAllIntervals)
{
  int limited = 0;
  int possible = 0;
  int undetermined = 0;
  int largestSpan = 0;
  for (std::int32_t vertex = 0; vertex < this->Stars.GetNumberOfVertices(); ++vertex)
  {
    const Sums sums = this->GetSums(vertex);
    lms3dVertexFit fit(this->Demands);
    const bool isPossible = this->AddTriangles(vertex, fit);
    ASSERT_EQ(isPossible, sums.Minimum <= sums.Maximum) << vertex;
    if (isPossible)
    {
      const double best = sums.Products / sums.Squares;
      const double expected = std::clamp(best, sums.Minimum, sums.Maximum);
      EXPECT_EQ(fit.IsDetermined(), sums.LargestShare >= 0.5) << vertex;
      EXPECT_NEAR(fit.GetInverse(), expected, 1e-12) << vertex;
      ++possible;
      undetermined += fit.IsDetermined() ? 0 : 1;
      largestSpan = std::max(largestSpan, sums.LargestSpan);
      limited += expected != best ? 1 : 0;
    }
  }
  EXPECT_GT(possible, 20);
  EXPECT_GT(limited, 3);
  EXPECT_LT(limited, possible);
  EXPECT_GT(undetermined, 0);
  EXPECT_LT(undetermined, possible);
  // The fit divides the beams of a column into parts.
  EXPECT_GT(largestSpan, 64);
}

TEST_F(VertexFit, AllowsWhatSatisfiesAllBeams)
{
  constexpr double Little = 1e-9;
  for (std::int32_t vertex = 0; vertex < this->Stars.GetNumberOfVertices(); ++vertex)
  {
    lms3dVertexFit fit(this->Demands);
    const Sums sums = this->GetSums(vertex);
    if (!this->AddTriangles(vertex, fit))
    {
      continue;
    }
    for (double end : { sums.Minimum, sums.Maximum })
    {
      for (double inverse : { end * (1.0 - Little), end * (1.0 + Little) })
      {
        const bool isAllowed = inverse >= sums.Minimum && inverse <= sums.Maximum;
        EXPECT_EQ(fit.Allows(inverse), isAllowed) << vertex;
        EXPECT_EQ(this->Allows(vertex, inverse), isAllowed) << vertex;
      }
    }
  }
}
