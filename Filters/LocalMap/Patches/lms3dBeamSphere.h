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
  using Place = std::int32_t;

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
  Place GetNumberOfPlaces() const { return this->Rows * this->Columns; }
  Place GetPlace(int column, int row) const { return column * this->Rows + row; }
  int GetColumn(Place place) const { return place / this->Rows; }
  int GetRow(Place place) const { return place % this->Rows; }

  /// False below the lowest row and above the highest.
  bool HasNeighbor(Place place, int side) const
  {
    return side % 2 == 1 || this->GetRow(place) != (side == Up ? this->Rows - 1 : 0);
  }

  /// Of a place that has one there.
  Place GetNeighbor(Place place, int side) const
  {
    switch (side)
    {
      case Up:
        return place + 1;
      case Down:
        return place - 1;
      case Right:
        return place + this->Rows < this->GetNumberOfPlaces() ? place + this->Rows
                                                              : place - this->LastColumn;
      default:
        return place >= this->Rows ? place - this->Rows : place + this->LastColumn;
    }
  }

  /// Whether two neighbours lie on one surface, or are the same pole.
  bool IsJoined(Place place, int side) const
  {
    switch (side)
    {
      case Up:
        return this->Joins[place] & JoinedUp;
      case Right:
        return this->Joins[place] & JoinedRight;
      default:
        return this->Joins[this->GetNeighbor(place, side)] &
          (side == Down ? JoinedUp : JoinedRight);
    }
  }

  /// Metres, 0 where there is no return.
  double GetRange(Place place) const { return this->Ranges[place]; }
  /// Half of the difference between the returns of a pole, which lie around its range; 0 elsewhere.
  double GetSpread(int row) const { return this->Spreads[row]; }
  /// The nearest and the farthest of the returns of a pole.
  void SetPole(int row, double nearest, double farthest);
  const double* GetRanges() const { return this->Ranges.data(); }
  bool HasReturn(Place place) const { return this->Ranges[place] > 0.0; }

  /// True for a pole's places but the first: repetitions of one return.
  bool IsRepeated(Place place) const
  {
    return place >= this->Rows && this->IsPoleRow(this->GetRow(place));
  }
  bool IsPoleRow(int row) const
  {
    return (row == 0 && this->LowestIsPole) || (row == this->Rows - 1 && this->HighestIsPole);
  }

  /// The beam of a row and the turn of a column in the scan, -1 for ghosts.
  int GetBeam(Place place) const { return this->RowTicks[this->GetRow(place)].Source; }
  int GetTurn(Place place) const { return this->ColumnTicks[this->GetColumn(place)].Source; }

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

  lms3dVector GetDirection(Place place) const
  {
    const std::array<double, 2>& level = this->Levels[this->GetColumn(place)];
    const int row = this->GetRow(place);
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
  Place LastColumn = 0;
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
