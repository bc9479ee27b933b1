// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridMesher.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace
{
constexpr double SmallestRelativeDepthStep = 0.02;

// Whether the plane through the returns at `before` and `at` goes on to the one at `next`.
bool IsPredicted(double before, double at, double next, double twoCosines, double tolerance)
{
  const double inverse = before > 0.0 ? twoCosines / at - 1.0 / before : 0.0;
  return inverse > 0.0 && std::abs(1.0 / inverse - next) <= tolerance;
}
} // namespace

/// Corners counter-clockwise as the sensor sees them: (turn, beam), (turn + 1, beam) and up again.
struct lms3dGridMesher::Cell
{
  std::array<std::int64_t, 4> Corners;
  /// Whether a corner's sides to the next corner are joined.
  std::array<bool, 4> Sides;
};

lms3dGridMesher::Spacing::Spacing(double stepInDegrees)
{
  double sine, cosine;
  lms3dSinCosDegrees(stepInDegrees, sine, cosine);
  this->TwoCosines = 2.0 * cosine;
  this->RelativeDepthStep = std::max(SmallestRelativeDepthStep, std::atan2(sine, cosine));
}

lms3dGridMesher::lms3dGridMesher(const lms3dRangeGrid& grid, const double* points, double depthStep)
  : Grid(grid)
  , Points(points)
  , DepthStep(depthStep)
  , AlongFan(grid.GetGeometry().GetAlphaStep())
  , AlongTurn(grid.GetGeometry().GetBetaStep())
{
}

std::vector<lms3dGridMesher::Triangle> lms3dGridMesher::MakeTriangles() const
{
  const int strips = this->Grid.GetNumberOfTurns() - (this->Grid.IsClosed() ? 0 : 1);
  std::vector<std::vector<Triangle>> ofStrips(std::max(strips, 0));
  tbb::parallel_for(0, strips, [&](int turn) { this->AppendStrip(turn, ofStrips[turn]); });

  std::vector<Triangle> triangles;
  for (const std::vector<Triangle>& strip : ofStrips)
  {
    triangles.insert(triangles.end(), strip.begin(), strip.end());
  }
  return triangles;
}

void lms3dGridMesher::AppendStrip(int turn, std::vector<Triangle>& out) const
{
  out.reserve(2 * static_cast<std::size_t>(this->Grid.GetNumberOfBeams()));
  for (int beam = 0; beam + 1 < this->Grid.GetNumberOfBeams(); ++beam)
  {
    this->AppendCell(this->GetCell(turn, beam), out);
  }
}

lms3dGridMesher::Cell lms3dGridMesher::GetCell(int turn, int beam) const
{
  return { { this->Grid.GetVertex(turn, beam), this->Grid.GetVertex(turn + 1, beam),
             this->Grid.GetVertex(turn + 1, beam + 1), this->Grid.GetVertex(turn, beam + 1) },
    { this->IsJoinedAlongTurn(turn, beam), this->IsJoinedAlongFan(turn + 1, beam),
      this->IsJoinedAlongTurn(turn, beam + 1), this->IsJoinedAlongFan(turn, beam) } };
}

bool lms3dGridMesher::IsJoinedAlongFan(int turn, int beam) const
{
  return this->IsJoined(
    { this->Grid.GetRange(turn, beam - 1), this->Grid.GetRange(turn, beam),
      this->Grid.GetRange(turn, beam + 1), this->Grid.GetRange(turn, beam + 2) },
    this->AlongFan);
}

bool lms3dGridMesher::IsJoinedAlongTurn(int turn, int beam) const
{
  return this->IsJoined(
    { this->Grid.GetRange(turn - 1, beam), this->Grid.GetRange(turn, beam),
      this->Grid.GetRange(turn + 1, beam), this->Grid.GetRange(turn + 2, beam) },
    this->AlongTurn);
}

// Of the four ranges in a row the middle ones are asked about.
bool lms3dGridMesher::IsJoined(const std::array<double, 4>& ranges, const Spacing& spacing) const
{
  const auto [before, a, b, after] = ranges;
  if (a <= 0.0 || b <= 0.0)
  {
    return false;
  }
  const double tolerance = this->DepthStep + spacing.RelativeDepthStep * std::min(a, b);
  return std::abs(a - b) <= tolerance || IsPredicted(before, a, b, spacing.TwoCosines, tolerance) ||
    IsPredicted(after, b, a, spacing.TwoCosines, tolerance);
}

double lms3dGridMesher::GetSquaredDistance(std::int64_t a, std::int64_t b) const
{
  if (a == lms3dRangeGrid::NoVertex || b == lms3dRangeGrid::NoVertex)
  {
    return 0.0;
  }
  const std::vector<std::int64_t>& returns = this->Grid.GetReturns();
  const double* p = this->Points + 3 * returns[a];
  const double* q = this->Points + 3 * returns[b];
  const double d[3] = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

void lms3dGridMesher::AppendCell(const Cell& cell, std::vector<Triangle>& out) const
{
  const std::array<std::int64_t, 4>& corner = cell.Corners;
  // The triangle at a corner has the cell's sides before and after the corner. At a pole two
  // corners are one, and the triangle between them has no area.
  const auto isWhole = [&](int i)
  {
    const std::int64_t before = corner[(i + 3) % 4];
    const std::int64_t after = corner[(i + 1) % 4];
    return cell.Sides[(i + 3) % 4] && cell.Sides[i] && before != corner[i] && corner[i] != after &&
      before != after;
  };
  const std::array<bool, 4> whole = { isWhole(0), isWhole(1), isWhole(2), isWhole(3) };

  // One diagonal cuts off corners 0 and 2, the other 1 and 3. More triangles go before shortness.
  const int even = whole[0] + whole[2];
  const int odd = whole[1] + whole[3];
  const bool takeOdd = odd > even ||
    (odd == even &&
      this->GetSquaredDistance(corner[0], corner[2]) <=
        this->GetSquaredDistance(corner[1], corner[3]));
  for (int i = takeOdd ? 1 : 0; i < 4; i += 2)
  {
    if (whole[i])
    {
      out.push_back({ corner[(i + 3) % 4], corner[i], corner[(i + 1) % 4] });
    }
  }
}
