// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridNormals.h"

#include "lms3dStripPoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;
using Row = std::vector<double>;

/// What a strip adds to one coordinate of the normals at its cells' corners.
struct CornerSums
{
  explicit CornerSums(int beams)
  {
    for (Row& row : this->OfCorner)
    {
      row.resize(beams);
    }
  }

  // `u` and `v` are the other two coordinates of the strip's points, in the order of the axes.
  // A triangle's normal, as long as twice its area, is the cross product of its grid sides.
  void Fill(const lms3dStripPoints& points, int u, int v, const std::uint8_t* cells, int count)
  {
    const double* hereU = points.GetHere()[u].data();
    const double* hereV = points.GetHere()[v].data();
    const double* nextU = points.GetNext()[u].data();
    const double* nextV = points.GetNext()[v].data();
    double* corner0 = this->OfCorner[0].data();
    double* corner1 = this->OfCorner[1].data();
    double* corner2 = this->OfCorner[2].data();
    double* corner3 = this->OfCorner[3].data();
    for (int i = 0; i < count; ++i)
    {
      const double u0 = nextU[i] - hereU[i];
      const double v0 = nextV[i] - hereV[i];
      const double u1 = nextU[i + 1] - nextU[i];
      const double v1 = nextV[i + 1] - nextV[i];
      const double u2 = hereU[i + 1] - nextU[i + 1];
      const double v2 = hereV[i + 1] - nextV[i + 1];
      const double u3 = hereU[i] - hereU[i + 1];
      const double v3 = hereV[i] - hereV[i + 1];
      const double n0 = (cells[i] & 1) * (u3 * v0 - v3 * u0);
      const double n1 = (cells[i] >> 1 & 1) * (u0 * v1 - v0 * u1);
      const double n2 = (cells[i] >> 2 & 1) * (u1 * v2 - v1 * u2);
      const double n3 = (cells[i] >> 3 & 1) * (u2 * v3 - v2 * u3);
      const double even = n0 + n2;
      const double odd = n1 + n3;
      corner0[i] = odd + n0;
      corner1[i] = even + n1;
      corner2[i] = odd + n2;
      corner3[i] = even + n3;
    }
  }

  static void Add(const Row& left, const Row& right, int count, Row& sums)
  {
    sums[0] += left[0];
    for (int i = 1; i < count; ++i)
    {
      sums[i] += left[i] + right[i - 1];
    }
    sums[count] += right[count - 1];
  }

  std::array<Row, 4> OfCorner;
};
} // namespace

/// Sums of normals of a turn.
class TurnSums
{
public:
  explicit TurnSums(int beams)
  {
    for (Row& row : this->Sums)
    {
      row.resize(beams);
    }
  }
  std::array<Row, 3> Sums;
};

void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const double* points, const std::array<double, 3>& sensor, float* normals)
{
  const int beams = grid.GetNumberOfBeams();
  std::vector<std::uint8_t> isPole(beams, 0);
  for (int pole : grid.GetPoles())
  {
    isPole[pole] = 1;
  }
  std::vector<Vector> poleSums(grid.GetPoles().size() * grid.GetNumberOfTurns());
  const auto write = [&](std::int32_t vertex, const Vector& sum)
  {
    Vector n = sum;
    double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(square > 0.0))
    {
      const double* p = points + 3 * static_cast<std::ptrdiff_t>(vertex);
      n = { sensor[0] - p[0], sensor[1] - p[1], sensor[2] - p[2] };
      square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    }
    const double scale = 1.0 / std::sqrt(square);
    float* out = normals + 3 * static_cast<std::ptrdiff_t>(vertex);
    out[0] = static_cast<float>(n[0] * scale);
    out[1] = static_cast<float>(n[1] * scale);
    out[2] = static_cast<float>(n[2] * scale);
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.GetNumberOfTurns(), 8),
    [&](const tbb::blocked_range<int>& turns)
    {
      lms3dStripPoints strip(grid, points, turns.begin() - 1);
      CornerSums corners(beams);
      TurnSums here(beams), next(beams);
      for (int turn = turns.begin() - 1; turn < turns.end(); ++turn)
      {
        strip.MoveTo(turn);
        for (int axis = 0; axis < 3 && beams > 1; ++axis)
        {
          corners.Fill(strip, (axis + 1) % 3, (axis + 2) % 3, mesher.GetCells(turn), beams - 1);
          CornerSums::Add(corners.OfCorner[0], corners.OfCorner[3], beams - 1, here.Sums[axis]);
          next.Sums[axis].assign(beams, 0.0);
          CornerSums::Add(corners.OfCorner[1], corners.OfCorner[2], beams - 1, next.Sums[axis]);
        }
        if (turn >= turns.begin())
        {
          const std::int32_t* vertices = grid.GetVertices(turn);
          for (int i = 0; i < beams; ++i)
          {
            if (vertices[i] != lms3dRangeGrid::NoVertex && !isPole[i])
            {
              write(vertices[i], { here.Sums[0][i], here.Sums[1][i], here.Sums[2][i] });
            }
          }
          for (std::size_t i = 0; i < grid.GetPoles().size(); ++i)
          {
            const int p = grid.GetPoles()[i];
            poleSums[i * grid.GetNumberOfTurns() + turn] = { here.Sums[0][p], here.Sums[1][p],
              here.Sums[2][p] };
          }
        }
        std::swap(here, next);
      }
    });
  for (std::size_t i = 0; i < grid.GetPoles().size(); ++i)
  {
    const std::int32_t vertex = grid.GetVertex(0, grid.GetPoles()[i]);
    if (vertex == lms3dRangeGrid::NoVertex)
    {
      continue;
    }
    Vector sum{};
    for (int turn = 0; turn < grid.GetNumberOfTurns(); ++turn)
    {
      const Vector& part = poleSums[i * grid.GetNumberOfTurns() + turn];
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += part[axis];
      }
    }
    write(vertex, sum);
  }
}
