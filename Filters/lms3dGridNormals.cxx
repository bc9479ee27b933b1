// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dGridNormals.h"

#include "lms3dStripPoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;
using Row = std::vector<double>;

// Each range of turns looks at the strip before it once more, so it should not be short.
constexpr int FewestTurns = 16;

Vector Scale(const Vector& v, double by)
{
  return { v[0] * by, v[1] * by, v[2] * by };
}

Vector Add(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

double GetInverseLength(const Vector& v)
{
  return 1.0 / std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// Not so where triangles are missing, or too small or too large for the square of an area.
bool IsProperScale(double scale)
{
  return scale > 0.0 && scale < std::numeric_limits<double>::infinity();
}

/// The sums of normals of a piece of a turn, turn after turn. As in lms3dStripPoints, the sizes are
/// fixed.
class NormalTile
{
public:
  /// For the beams `firstBeam` to GetEndBeam(), which have a cell before them and one after.
  NormalTile(
    const lms3dRangeGrid& grid, const lms3dGridMesher& mesher, const double* points, int firstBeam)
    : Mesher(mesher)
    , FirstCell(firstBeam - 1)
    , Points(grid, points, firstBeam - 1)
    , Cells(this->Points.GetNumberOfBeams() - 1)
  {
  }

  int GetFirstBeam() const { return this->FirstCell + 1; }
  int GetEndBeam() const { return this->FirstCell + this->Cells; }

  /// Before the first turn; then MoveTo goes from turn to turn.
  void Start(int turn)
  {
    this->Fetch(turn - 1);
    this->MoveTo(turn - 1);
  }

  void MoveTo(int turn)
  {
    this->Fetch(turn + 1);
    this->SetWeights(turn);
    this->AddTriangles<0>();
    this->AddTriangles<1>();
    this->AddTriangles<2>();
    this->FindScales();
  }

  Vector GetSum(int beam) const
  {
    const int i = beam - this->FirstCell;
    return { this->Sums[0][i], this->Sums[1][i], this->Sums[2][i] };
  }

  /// 1 / length of the sum.
  double GetScale(int beam) const { return this->Scales[beam - this->FirstCell]; }

private:
  using Row = lms3dStripPoints::Row;
  using Rows = lms3dStripPoints::Rows;

  void Fetch(int turn)
  {
    this->Points.Fetch(turn);
    this->HereSides = this->NextSides;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i <= this->Cells; ++i)
      {
        this->AcrossSides[axis][i] = this->Points.Next[axis][i] - this->Points.Here[axis][i];
      }
      for (int i = 0; i < this->Cells; ++i)
      {
        this->NextSides[axis][i] = this->Points.Next[axis][i + 1] - this->Points.Next[axis][i];
      }
    }
  }

  void SetWeights(int turn)
  {
    const std::uint8_t* cells = this->Mesher.GetCells(turn) + this->FirstCell;
    for (int i = 0; i < this->Cells; ++i)
    {
      this->Weights[0][i] = cells[i] & 1;
      this->Weights[1][i] = cells[i] >> 1 & 1;
      this->Weights[2][i] = cells[i] >> 2 & 1;
      this->Weights[3][i] = cells[i] >> 3 & 1;
    }
  }

  // A triangle's normal, as long as twice its area, is the cross product of its sides along the
  // grid. Triangles of opposite corners meet at the other two.
  template <int Axis>
  void AddTriangles()
  {
    constexpr int u = (Axis + 1) % 3;
    constexpr int v = (Axis + 2) % 3;
    const Row& acrossU = this->AcrossSides[u];
    const Row& acrossV = this->AcrossSides[v];
    for (int i = 0; i < this->Cells; ++i)
    {
      const double hereU = this->HereSides[u][i];
      const double hereV = this->HereSides[v][i];
      const double nextU = this->NextSides[u][i];
      const double nextV = this->NextSides[v][i];
      const double n0 = this->Weights[0][i] * (acrossU[i] * hereV - acrossV[i] * hereU);
      const double n1 = this->Weights[1][i] * (acrossU[i] * nextV - acrossV[i] * nextU);
      const double n2 = this->Weights[2][i] * (acrossU[i + 1] * nextV - acrossV[i + 1] * nextU);
      const double n3 = this->Weights[3][i] * (acrossU[i + 1] * hereV - acrossV[i + 1] * hereU);
      const double even = n0 + n2;
      const double odd = n1 + n3;
      this->AtBegin[Axis][i] = this->NextAtBegin[Axis][i] + (odd + n0);
      this->AtEnd[Axis][i] = this->NextAtEnd[Axis][i] + (even + n3);
      this->NextAtBegin[Axis][i] = even + n1;
      this->NextAtEnd[Axis][i] = odd + n2;
    }
    for (int i = 1; i < this->Cells; ++i)
    {
      this->Sums[Axis][i] = this->AtBegin[Axis][i] + this->AtEnd[Axis][i - 1];
    }
  }

  void FindScales()
  {
    for (int i = 1; i < this->Cells; ++i)
    {
      const double x = this->Sums[0][i];
      const double y = this->Sums[1][i];
      const double z = this->Sums[2][i];
      this->Scales[i] = 1.0 / std::sqrt(x * x + y * y + z * z);
    }
  }

  const lms3dGridMesher& Mesher;
  const int FirstCell;
  lms3dStripPoints Points;
  const int Cells;

  /// The sides of cells: from turn to turn, and from beam to beam of both turns.
  Rows AcrossSides = {};
  Rows HereSides = {};
  Rows NextSides = {};
  /// For each corner 1 or 0: whether a cell has its triangle.
  std::array<Row, 4> Weights = {};
  /// What cells add at the beam where they begin, and at the one where they end.
  Rows AtBegin = {};
  Rows AtEnd = {};
  Rows NextAtBegin = {};
  Rows NextAtEnd = {};
  Rows Sums = {};
  Row Scales = {};
};

class NormalWriter
{
public:
  NormalWriter(const lms3dRangeGrid& grid, const double* points,
    const std::array<double, 3>& sensor, float* normals)
    : Grid(grid)
    , Points(points)
    , Sensor(sensor)
    , Normals(normals)
    , PoleSums(grid.GetPoles().size() * grid.GetNumberOfTurns())
  {
  }

  /// A pole is a vertex of the first turn, to which all turns add.
  void WriteTurn(int turn, const NormalTile& tile)
  {
    const std::int32_t* vertices = this->Grid.GetVertices(turn);
    const std::int32_t first = this->Grid.GetFirstVertex(turn);
    for (int beam = tile.GetFirstBeam(); beam < tile.GetEndBeam(); ++beam)
    {
      if (vertices[beam] >= first)
      {
        this->Write(vertices[beam], tile.GetSum(beam), tile.GetScale(beam));
      }
    }
    const std::vector<int>& poles = this->Grid.GetPoles();
    for (std::size_t i = 0; i < poles.size(); ++i)
    {
      if (poles[i] >= tile.GetFirstBeam() && poles[i] < tile.GetEndBeam())
      {
        this->PoleSums[turn * poles.size() + i] = tile.GetSum(poles[i]);
      }
    }
  }

  /// After all turns.
  void WritePoles()
  {
    const std::vector<int>& poles = this->Grid.GetPoles();
    for (std::size_t i = 0; i < poles.size(); ++i)
    {
      Vector sum = {};
      for (std::size_t part = i; part < this->PoleSums.size(); part += poles.size())
      {
        sum = Add(sum, this->PoleSums[part]);
      }
      if (this->Grid.HasReturn(0, poles[i]))
      {
        this->Write(this->Grid.GetVertex(0, poles[i]), sum, GetInverseLength(sum));
      }
    }
  }

private:
  void Write(std::int32_t vertex, const Vector& sum, double scale)
  {
    const std::ptrdiff_t place = 3 * static_cast<std::ptrdiff_t>(vertex);
    const Vector normal =
      IsProperScale(scale) ? Scale(sum, scale) : this->GetDirectionToSensor(this->Points + place);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Normals[place + axis] = static_cast<float>(normal[axis]);
    }
  }

  Vector GetDirectionToSensor(const double* point) const
  {
    const Vector way = { this->Sensor[0] - point[0], this->Sensor[1] - point[1],
      this->Sensor[2] - point[2] };
    return Scale(way, 1.0 / std::hypot(way[0], way[1], way[2]));
  }

  const lms3dRangeGrid& Grid;
  const double* const Points;
  const Vector Sensor;
  float* const Normals;
  std::vector<Vector> PoleSums;
};
} // namespace

void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const double* points, const std::array<double, 3>& sensor, float* normals)
{
  NormalWriter writer(grid, points, sensor, normals);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.GetNumberOfTurns(), FewestTurns),
    [&](const tbb::blocked_range<int>& turns)
    {
      for (int beam = 0; beam < grid.GetNumberOfBeams();)
      {
        NormalTile tile(grid, mesher, points, beam);
        tile.Start(turns.begin());
        for (int turn = turns.begin(); turn < turns.end(); ++turn)
        {
          tile.MoveTo(turn);
          writer.WriteTurn(turn, tile);
        }
        beam = tile.GetEndBeam();
      }
    });
  writer.WritePoles();
}
