// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dGridNormals.h"

#include "Kernels/lms3dPacketKernels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

// Each range of turns looks at the strip before it once more, so it should not be short.
constexpr int MinimumTurnsPerTask = 16;

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

/// Fetches what a tile sums, turn after turn.
class NormalTile
{
public:
  /// For the beams `firstBeam` to GetEndBeam(), which have a point before them and one after.
  NormalTile(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
    const lms3dGridPoints& points, int firstBeam)
    : Kernels(lms3dGetPacketKernels())
    , Mesher(mesher)
    , Points(points)
    , FirstCell(firstBeam - 1)
    , Cells(std::min(lms3dNormalTile::Cells, grid.GetNumberOfBeams() - this->FirstCell))
  {
  }

  int GetFirstBeam() const { return this->FirstCell + 1; }
  int GetEndBeam() const { return this->FirstCell + this->Cells; }

  /// To the turn before the first, then always to the next.
  void MoveTo(int turn)
  {
    const std::uint8_t* cells = this->Mesher.GetCells(turn) + this->FirstCell;
    const bool isEmpty =
      std::all_of(cells, cells + this->Cells, [](std::uint8_t cell) { return cell == 0; });
    this->HasSums = !isEmpty || !this->WasEmpty;
    if (!this->HasSums)
    {
      return;
    }
    if (this->WasEmpty)
    {
      this->Begin(turn);
    }
    this->Fetch(turn + 1);
    std::copy_n(cells, this->Cells, this->Tile.Triangles);
    this->Kernels.AddStrip(this->Tile);
    this->WasEmpty = isEmpty;
  }

  Vector GetSum(int beam) const
  {
    const int i = beam - this->FirstCell;
    return !this->HasSums
      ? Vector{}
      : Vector{ this->Tile.Sum[0][i], this->Tile.Sum[1][i], this->Tile.Sum[2][i] };
  }

  /// 1 / length of the sum; not proper where there is none.
  double GetScale(int beam) const
  {
    return this->HasSums ? this->Tile.Scale[beam - this->FirstCell] : 0.0;
  }

private:
  // With nothing from the strip before.
  void Begin(int turn)
  {
    this->Fetch(turn);
    this->Kernels.AddStrip(this->Tile);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::fill_n(this->Tile.NextBegin[axis], lms3dNormalTile::Cells, 0.0);
      std::fill_n(this->Tile.NextEnd[axis], lms3dNormalTile::Cells, 0.0);
    }
  }

  void Fetch(int turn)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* coordinates = this->Points.GetRow(axis, turn) + this->FirstCell;
      std::copy_n(coordinates, this->Cells + 1, this->Tile.Next[axis]);
    }
  }

  const lms3dPacketKernels& Kernels;
  const lms3dGridMesher& Mesher;
  const lms3dGridPoints& Points;
  const int FirstCell;
  const int Cells;
  bool WasEmpty = true;
  bool HasSums = false;
  lms3dNormalTile Tile = {};
};

class NormalWriter
{
public:
  NormalWriter(const lms3dRangeGrid& grid, const lms3dGridPoints& points,
    const std::array<double, 3>& sensor, float* normals)
    : Grid(grid)
    , Points(points)
    , Sensor(sensor)
    , Normals(normals)
    , Sign(grid.GetGeometry().IsMirrored() ? -1.0 : 1.0)
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
        this->Write(turn, beam, tile.GetSum(beam), tile.GetScale(beam));
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
        this->Write(0, poles[i], sum, GetInverseLength(sum));
      }
    }
  }

private:
  void Write(int turn, int beam, const Vector& sum, double scale)
  {
    const Vector normal = IsProperScale(scale) ? Scale(sum, this->Sign * scale)
                                               : this->GetDirectionToSensor(turn, beam);
    float* out = this->Normals + 3 * static_cast<std::ptrdiff_t>(this->Grid.GetVertex(turn, beam));
    for (int axis = 0; axis < 3; ++axis)
    {
      out[axis] = static_cast<float>(normal[axis]);
    }
  }

  Vector GetDirectionToSensor(int turn, int beam) const
  {
    Vector way = this->Sensor;
    for (int axis = 0; axis < 3; ++axis)
    {
      way[axis] -= this->Points.GetRow(axis, turn)[beam];
    }
    return Scale(way, 1.0 / std::hypot(way[0], way[1], way[2]));
  }

  const lms3dRangeGrid& Grid;
  const lms3dGridPoints& Points;
  const Vector Sensor;
  float* const Normals;
  /// The sums face the sensor, or away from it.
  const double Sign;
  std::vector<Vector> PoleSums;
};
} // namespace

void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const lms3dGridPoints& points, const std::array<double, 3>& sensor, float* normals)
{
  NormalWriter writer(grid, points, sensor, normals);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.GetNumberOfTurns(), MinimumTurnsPerTask),
    [&](const tbb::blocked_range<int>& turns)
    {
      for (int beam = 0; beam < grid.GetNumberOfBeams();)
      {
        NormalTile tile(grid, mesher, points, beam);
        tile.MoveTo(turns.begin() - 1);
        for (int turn = turns.begin(); turn < turns.end(); ++turn)
        {
          tile.MoveTo(turn);
          if (grid.HasReturns(turn))
          {
            writer.WriteTurn(turn, tile);
          }
        }
        beam = tile.GetEndBeam();
      }
    });
  writer.WritePoles();
}
