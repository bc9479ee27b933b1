// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a scan as places on the sphere of directions, with misses all around.
 */
#ifndef lms3dBeamSphere_h
#define lms3dBeamSphere_h

#include "Geometry/lms3dVector.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Rows of growing elevation and columns of growing platform angle, in the sensor frame. Where the
 * scan ends, ghosts go on with its steps: places that hold no return. So the columns always close
 * to a circle, no angle between neighbours exceeds 120 degrees, and every return but a pole has
 * four neighbours. The places of a pole, one in each column, hold the same return.
 */
class lms3dBeamSphere
{
public:
  using GridIndex = std::int32_t;

  /// The sides of a place in the order of the clock, as the sensor sees them.
  enum Side : int
  {
    Up,
    Right,
    Down,
    Left
  };

  /// Throws std::runtime_error where angles do not grow or fall steadily, elevations exceed 90
  /// degrees or turns 360.
  lms3dBeamSphere(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins);

  int GetNumberOfRows() const { return this->Rows; }
  int GetNumberOfColumns() const { return this->Columns; }
  GridIndex GetSize() const { return this->Rows * this->Columns; }
  GridIndex GetIndex(int column, int row) const { return column * this->Rows + row; }
  int GetColumn(GridIndex index) const { return index / this->Rows; }
  int GetRow(GridIndex index) const { return index % this->Rows; }

  /// False below the lowest row and above the highest.
  bool HasNeighbor(GridIndex index, int side) const
  {
    return side % 2 == 1 || this->GetRow(index) != (side == Up ? this->Rows - 1 : 0);
  }

  /// Of a place that has one there.
  GridIndex GetNeighbor(GridIndex index, int side) const
  {
    switch (side)
    {
      case Up:
        return index + 1;
      case Down:
        return index - 1;
      case Right:
        return index + this->Rows < this->GetSize() ? index + this->Rows : index - this->LastColumn;
      default:
        return index >= this->Rows ? index - this->Rows : index + this->LastColumn;
    }
  }

  /// Whether two neighbours lie on one surface, or are the same pole.
  bool IsJoined(GridIndex index, int side) const
  {
    switch (side)
    {
      case Up:
        return this->Joins[index] & JoinedUp;
      case Right:
        return this->Joins[index] & JoinedRight;
      default:
        return this->Joins[this->GetNeighbor(index, side)] &
          (side == Down ? JoinedUp : JoinedRight);
    }
  }

  /// Metres, 0 where there is no return.
  double GetRange(GridIndex index) const { return this->Ranges[index]; }
  /// Half of the difference between the returns of a pole, which lie around its range; 0 elsewhere.
  double GetSpread(int row) const { return this->Spreads[row]; }
  /// The nearest and the farthest of the returns of a pole.
  void SetPole(int row, double nearest, double farthest);
  const double* GetRanges() const { return this->Ranges.data(); }
  bool HasReturn(GridIndex index) const { return this->Ranges[index] > 0.0; }

  /// True for a pole's places but the first: repetitions of one return.
  bool IsRepeated(GridIndex index) const
  {
    return index >= this->Rows && this->IsPoleRow(this->GetRow(index));
  }
  bool IsPoleRow(int row) const
  {
    return (row == 0 && this->LowestIsPole) || (row == this->Rows - 1 && this->HighestIsPole);
  }

  /// The beam of a row and the turn of a column in the scan, -1 for ghosts.
  int GetBeam(GridIndex index) const { return this->RowTicks[this->GetRow(index)].Source; }
  int GetTurn(GridIndex index) const { return this->ColumnTicks[this->GetColumn(index)].Source; }

  /// A pole counts once.
  int GetNumberOfReturns() const { return this->Returns; }

  const double* GetCosines() const { return this->Cosines.data(); }
  const double* GetSines() const { return this->Sines.data(); }
  /// The tangents of the elevations, growing; infinite at the poles.
  const std::vector<double>& GetTangents() const { return this->Tangents; }
  /// The platform angles in radians, growing, over less than a full circle.
  const std::vector<double>& GetAzimuths() const { return this->Azimuths; }
  /// The level direction of a column: a direction is its cosine and the upward axis times its sine.
  const std::array<double, 2>& GetLevel(int column) const { return this->Levels[column]; }

  lms3dVector GetDirection(GridIndex index) const
  {
    const std::array<double, 2>& level = this->Levels[this->GetColumn(index)];
    const int row = this->GetRow(index);
    return { this->Cosines[row] * level[0], this->Cosines[row] * level[1], this->Sines[row] };
  }

private:
  enum Join : std::uint8_t
  {
    JoinedUp = 1,
    JoinedRight = 2
  };

  /// An angle in degrees and the beam or turn that it belongs to, -1 for a ghost.
  struct Tick
  {
    double Angle;
    int Source;
  };

  static std::vector<Tick> MakeTicks(const std::vector<double>& angles, const char* name);
  static void FillGaps(std::vector<Tick>& ticks, double step);
  void MakeRows(const std::vector<double>& angles, double step);
  void MakeColumns(const std::vector<double>& angles, double step, bool isClosed);
  void SetRow(int row, double degrees);
  void Fill(const lms3dRangeGrid& grid);
  int FillColumn(const lms3dRangeGrid& grid, int column);
  void Join(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins);
  void JoinUp(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column);
  void JoinRight(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column);

  int Rows = 0;
  int Columns = 0;
  GridIndex LastColumn = 0;
  int Returns = 0;
  bool LowestIsPole = false;
  bool HighestIsPole = false;
  std::vector<Tick> RowTicks;
  std::vector<Tick> ColumnTicks;
  std::vector<double> Cosines;
  std::vector<double> Sines;
  std::vector<double> Tangents;
  std::vector<double> Azimuths;
  std::vector<std::array<double, 2>> Levels;
  std::vector<double> Ranges;
  std::vector<double> Spreads;
  std::vector<std::uint8_t> Joins;
};

#endif
