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
// Each task computes the turn before its first one again, so it should not be short.
constexpr int MinimumTurnsPerTask = 16;

// False if a vertex has no triangles, or if squared areas underflow or overflow.
bool IsProperScale(double scale)
{
  return scale > 0.0 && scale < std::numeric_limits<double>::infinity();
}

/// Gives the kernels the points of a strip of beams, turn after turn.
class NormalStrip
{
public:
  /// Takes the beams from `firstBeam` to before GetEndBeam().
  NormalStrip(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
    const lms3dGridPoints& points, int firstBeam)
    : Kernels(lms3dGetPacketKernels())
    , Mesher(mesher)
    , Points(points)
    , FirstCell(firstBeam - 1)
    , Cells(std::min(lms3dNormalStrip::Cells, grid.GetNumberOfBeams() - this->FirstCell))
  {
  }

  int GetFirstBeam() const { return this->FirstCell + 1; }
  int GetEndBeam() const { return this->FirstCell + this->Cells; }

  /// Moves to a turn. The first call takes the turn before the first one needed, each other call
  /// the next.
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
    std::copy_n(cells, this->Cells, this->Strip.Triangles);
    this->Kernels.AddStrip(this->Strip);
    this->WasEmpty = isEmpty;
  }

  lms3dVector GetSum(int beam) const
  {
    const int i = beam - this->FirstCell;
    return !this->HasSums
      ? lms3dVector{}
      : lms3dVector{ this->Strip.Sum[0][i], this->Strip.Sum[1][i], this->Strip.Sum[2][i] };
  }

  /// 1 / length of the sum; 0 if there is no sum. See IsProperScale().
  double GetScale(int beam) const
  {
    return this->HasSums ? this->Strip.Scale[beam - this->FirstCell] : 0.0;
  }

private:
  // Starts without sums from the turn before.
  void Begin(int turn)
  {
    this->Fetch(turn);
    this->Kernels.AddStrip(this->Strip);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::fill_n(this->Strip.NextBegin[axis], lms3dNormalStrip::Cells, 0.0);
      std::fill_n(this->Strip.NextEnd[axis], lms3dNormalStrip::Cells, 0.0);
    }
  }

  void Fetch(int turn)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* coordinates = this->Points.GetRow(axis, turn) + this->FirstCell;
      std::copy_n(coordinates, this->Cells + 1, this->Strip.Next[axis]);
    }
  }

  const lms3dPacketKernels& Kernels;
  const lms3dGridMesher& Mesher;
  const lms3dGridPoints& Points;
  const int FirstCell;
  const int Cells;
  bool WasEmpty = true;
  bool HasSums = false;
  lms3dNormalStrip Strip = {};
};

class NormalWriter
{
public:
  NormalWriter(const lms3dRangeGrid& grid, const lms3dGridPoints& points, const lms3dVector& sensor,
    float* normals)
    : Grid(grid)
    , Points(points)
    , Sensor(sensor)
    , Normals(normals)
    , Sign(grid.GetGeometry().IsMirrored() ? -1.0 : 1.0)
    , PoleSums(grid.GetPoles().size() * grid.GetNumberOfTurns())
  {
  }

  /// Writes the normals of a turn, and keeps the sums of its poles.
  void WriteTurn(int turn, const NormalStrip& strip)
  {
    const std::int32_t* vertices = this->Grid.GetVertices(turn);
    const std::int32_t first = this->Grid.GetFirstVertex(turn);
    for (int beam = strip.GetFirstBeam(); beam < strip.GetEndBeam(); ++beam)
    {
      if (vertices[beam] >= first)
      {
        this->Write(turn, beam, strip.GetSum(beam), strip.GetScale(beam));
      }
    }
    const std::vector<int>& poles = this->Grid.GetPoles();
    for (std::size_t i = 0; i < poles.size(); ++i)
    {
      if (poles[i] >= strip.GetFirstBeam() && poles[i] < strip.GetEndBeam())
      {
        this->PoleSums[turn * poles.size() + i] = strip.GetSum(poles[i]);
      }
    }
  }

  /// Adds the sums of all turns. To be called after all turns.
  void WritePoles()
  {
    const std::vector<int>& poles = this->Grid.GetPoles();
    for (std::size_t i = 0; i < poles.size(); ++i)
    {
      lms3dVector sum = {};
      for (std::size_t part = i; part < this->PoleSums.size(); part += poles.size())
      {
        sum = lms3dAdd(sum, this->PoleSums[part]);
      }
      if (this->Grid.HasReturn(0, poles[i]))
      {
        this->Write(0, poles[i], sum, 1.0 / lms3dGetLength(sum));
      }
    }
  }

private:
  void Write(int turn, int beam, const lms3dVector& sum, double scale)
  {
    const lms3dVector normal = IsProperScale(scale) ? lms3dScale(sum, this->Sign * scale)
                                                    : this->GetDirectionToSensor(turn, beam);
    float* out = this->Normals + 3 * static_cast<std::ptrdiff_t>(this->Grid.GetVertex(turn, beam));
    for (int axis = 0; axis < 3; ++axis)
    {
      out[axis] = static_cast<float>(normal[axis]);
    }
  }

  lms3dVector GetDirectionToSensor(int turn, int beam) const
  {
    lms3dVector way = this->Sensor;
    for (int axis = 0; axis < 3; ++axis)
    {
      way[axis] -= this->Points.GetRow(axis, turn)[beam];
    }
    return lms3dScale(way, 1.0 / std::hypot(way[0], way[1], way[2]));
  }

  const lms3dRangeGrid& Grid;
  const lms3dGridPoints& Points;
  const lms3dVector Sensor;
  float* const Normals;
  /// -1 if the sums face away from the sensor.
  const double Sign;
  std::vector<lms3dVector> PoleSums;
};
} // namespace

void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const lms3dGridPoints& points, const lms3dVector& sensor, float* normals)
{
  NormalWriter writer(grid, points, sensor, normals);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.GetNumberOfTurns(), MinimumTurnsPerTask),
    [&](const tbb::blocked_range<int>& turns)
    {
      for (int beam = 0; beam < grid.GetNumberOfBeams();)
      {
        NormalStrip strip(grid, mesher, points, beam);
        strip.MoveTo(turns.begin() - 1);
        for (int turn = turns.begin(); turn < turns.end(); ++turn)
        {
          strip.MoveTo(turn);
          if (grid.HasReturns(turn))
          {
            writer.WriteTurn(turn, strip);
          }
        }
        beam = strip.GetEndBeam();
      }
    });
  writer.WritePoles();
}
