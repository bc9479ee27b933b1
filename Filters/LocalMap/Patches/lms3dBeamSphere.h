// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a scan as a grid on the sphere of directions, with a halo of misses.
 */
#ifndef lms3dBeamSphere_h
#define lms3dBeamSphere_h

#include "Geometry/lms3dVector.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"
#include "LocalMap/Patches/lms3dBeamRays.h"
#include "LocalMap/Patches/lms3dBeamVector.h"
#include "LocalMap/Patches/lms3dGridLines.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

/**
 * Rows have growing elevations and columns growing platform angles, whichever way the device
 * turned. Directions are in the frame of the map (lms3dMapGeometry), ranges in metres, angles in
 * radians.
 *
 * Where the scan ends, a halo of directions without returns continues it. Therefore
 *
 * - the columns always close to a full circle,
 * - neighbours are at most 120 degrees apart, and
 * - every return that is not a pole has four neighbours.
 *
 * A pole, where the beams of all turns coincide, fills a whole row: one entry in each column, all
 * with the same return.
 *
 * A GridIndex numbers the entries column by column, each from the lowest row to the highest.
 *
 * Beams that are not regular (lms3dMapGeometry) keep their places in the grid, but start and point
 * anywhere. Such an entry has the range and direction of its return, seen from the origin of the
 * frame. Its beam itself is a ray. Returns beyond the axis have no place: their entries have no
 * return, and the axis as their ray.
 */
class lms3dBeamSphere
{
public:
  using GridIndex = std::int32_t;

  /**
   * The largest number of entries, halo included: 2^28 - 1. Each entry has up to two gates, four
   * edges and eight vertices at borders (lms3dBorderGates), which all are numbered by 32-bit
   * integers.
   */
  static constexpr GridIndex MaximumSize = (1 << 28) - 1;

  /// The sides of an entry, clockwise as the sensor sees them.
  enum Side : int
  {
    Up,
    Right,
    Down,
    Left
  };

  /**
   * Copies what it needs. Uses the threads of the calling TBB arena. Throws std::runtime_error,
   * with a message for the user, if the angles are not strictly monotonic, if elevations exceed 90
   * degrees, if platform angles span a full circle or more without being closed, or if the grid
   * would be too large. Without a `geometry`, beams are regular.
   */
  lms3dBeamSphere(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
    const lms3dMapGeometry* geometry = nullptr);

  /// Throws std::runtime_error, with a message for the user, if a grid of these numbers of rows and
  /// columns has more than MaximumSize entries.
  static void CheckSize(std::int64_t rows, std::int64_t columns);

  int GetNumberOfRows() const { return this->Rows; }
  int GetNumberOfColumns() const { return this->Columns; }
  /// The number of entries, halo included.
  GridIndex GetSize() const { return this->Rows * this->Columns; }
  GridIndex GetIndex(int column, int row) const { return column * this->Rows + row; }
  int GetColumn(GridIndex index) const
  {
    // Instead of a division, which takes three times as long.
    return static_cast<int>(
      (static_cast<std::uint64_t>(index) * this->InverseOfRows) >> this->InverseShift);
  }
  int GetRow(GridIndex index) const { return index - this->GetColumn(index) * this->Rows; }

  /// False below the lowest row and above the highest.
  bool HasNeighbor(GridIndex index, int side) const
  {
    return side % 2 == 1 || this->GetRow(index) != (side == Up ? this->Rows - 1 : 0);
  }

  /// The neighbour on a side; it must exist.
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

  /// How an entry is joined with its neighbours, as bits.
  enum Join : std::uint8_t
  {
    JoinedUp = 1,
    JoinedRight = 2
  };
  /// By grid index.
  const std::uint8_t* GetJoins() const { return this->Joins.data(); }

  /// Whether an entry and its neighbour on a side lie on one surface (lms3dRangeJoins), or are the
  /// same pole.
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

  /// 0 without a return.
  double GetRange(GridIndex index) const { return this->Ranges[index]; }
  const double* GetRanges() const { return this->Ranges.data(); }
  bool HasReturn(GridIndex index) const { return this->Ranges[index] > 0.0; }

  ///@{
  /// Whether an entry has a range that is no return (lms3dRangeGrid::Fill). Such an entry is a part
  /// of its patch and does not count. Remove() takes the range away.
  bool IsFilled(GridIndex index) const { return !this->Filled.empty() && this->Filled[index] != 0; }
  bool HasFilled() const { return !this->Filled.empty(); }
  /// By grid index, 1 for such an entry and 0 for others. Only if HasFilled().
  const std::uint8_t* GetFilled() const { return this->Filled.data(); }
  void Remove(GridIndex index);
  ///@}

  /// Sets the nearest and the farthest return of a pole. Its range becomes their mean.
  void SetPole(int row, double nearest, double farthest);
  /// Half of the distance between these two returns, metres; 0 for rows that are not poles.
  double GetPoleHalfSpread(int row) const { return this->PoleHalfSpreads[row]; }
  const double* GetPoleHalfSpreads() const { return this->PoleHalfSpreads.data(); }

  bool IsPoleRow(int row) const
  {
    return (row == 0 && this->LowestIsPole) || (row == this->Rows - 1 && this->HighestIsPole);
  }
  /// Whether an entry repeats the return of a pole that column 0 has already.
  bool IsPoleCopy(GridIndex index) const
  {
    return index >= this->Rows && this->IsPoleRow(this->GetRow(index));
  }

  /// The beam and the turn of an entry in the scan, -1 in the halo.
  int GetBeam(GridIndex index) const { return this->RowLines[this->GetRow(index)].ScanIndex; }
  int GetTurn(GridIndex index) const { return this->ColumnLines[this->GetColumn(index)].ScanIndex; }

  /// Counts each pole once, and no filled entries.
  int GetNumberOfReturns() const { return this->Returns; }

  /// The cosines and sines of the rows' elevations.
  const double* GetCosines() const { return this->Cosines.data(); }
  const double* GetSines() const { return this->Sines.data(); }
  /// The tangents of the rows' elevations, growing; infinite at poles.
  const std::vector<double>& GetTangents() const { return this->Tangents; }
  /// The row of a tangent if rows were evenly spaced, or nearly that row. 0 to the number of rows.
  int GetRowNear(double tangent) const;
  /// The platform angles of the columns, growing, over less than a full circle.
  const std::vector<double>& GetAzimuths() const { return this->Azimuths; }
  /// The x and y of the horizontal direction of a column. A beam is the row's cosine times this,
  /// plus the row's sine times the z axis.
  const std::array<double, 2>& GetHorizontal(int column) const { return this->Horizontals[column]; }

  /// A unit vector. Without a return, beams that are not regular have the direction of the point at
  /// the range of a neighbour.
  lms3dVector GetDirection(GridIndex index) const
  {
    if (this->Rays)
    {
      return this->Directions[index];
    }
    const std::array<double, 2>& horizontal = this->Horizontals[this->GetColumn(index)];
    const int row = this->GetRow(index);
    return { this->Cosines[row] * horizontal[0], this->Cosines[row] * horizontal[1],
      this->Sines[row] };
  }

  ///@{
  /// Whether all beams start at the origin, at the elevation of their row and the angle of their
  /// column. If not, the ray of each beam.
  bool IsRegular() const { return !this->Rays; }
  const lms3dBeamRays& GetRays() const { return *this->Rays; }
  ///@}

  /// The range from the start of the beam, metres; 0 without a return.
  double GetRangeOnBeam(GridIndex index) const
  {
    return this->Rays ? this->RangesOnBeams[index] : this->Ranges[index];
  }

  /// The direction of the point where the beam `other` would meet a surface at the range of `own`,
  /// which has a return.
  lms3dVector GetDirectionBeside(GridIndex own, GridIndex other) const
  {
    return this->Rays ? this->GetDirectionAt(other, this->RangesOnBeams[own])
                      : this->GetDirection(other);
  }

  /// The point on a beam at a range from the start of the beam. Beams must not be regular.
  lms3dVector GetPointOnRay(GridIndex index, double range) const
  {
    const lms3dMapRay& ray = (*this->Rays)[index];
    return lms3dAdd(ray.Origin, lms3dScale(ray.Direction, range));
  }

  /// In a column, rows that many apart were measured in the same turn of the mirror.
  int GetInterlacedRows() const { return this->InterlacedRows; }

  /// The points of returns beyond the axis.
  const std::vector<lms3dVector>& GetPointsBeyondAxis() const { return this->PointsBeyondAxis; }

private:
  /// Consecutive rows of the scan. Their beams are consecutive, too.
  struct RowRun
  {
    int First;
    int Count;
    int FirstBeam;
    /// 1 or -1: to the beam of the next row.
    int Step;
  };

  void MakeRows(const std::vector<double>& angles, double step, bool arePoles);
  void FindRowRuns();
  void MakeColumns(const std::vector<double>& angles, double step, bool isClosed, int seam);
  void Fill(const lms3dRangeGrid& grid);
  int FillColumn(const lms3dRangeGrid& grid, int column);
  int MarkFilled(const lms3dRangeGrid& grid, int column);
  void FollowRays(const lms3dMapGeometry& geometry);
  void PointAtNeighbors(const lms3dMapGeometry& geometry);
  bool IsBeyondAxis(const lms3dMapGeometry& geometry, GridIndex index, double range) const;
  lms3dVector GetDirectionAt(GridIndex index, double range) const
  {
    return lms3dNormalize(this->GetPointOnRay(index, range));
  }
  void Join(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins);
  void JoinUp(const lms3dRangeJoins& joins, int column);
  void JoinRight(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins, int column);

  int Rows = 0;
  int Columns = 0;
  /// The smallest power of 2 that is at least 2^28 * Rows, as its exponent, and that power / Rows,
  /// rounded up. Indices are below 2^28, so rounding adds less than 1 / Rows to index / Rows.
  int InverseShift = 28;
  std::uint64_t InverseOfRows = 0;
  /// The index of the lowest entry of the last column.
  GridIndex LastColumn = 0;
  int Returns = 0;
  bool LowestIsPole = false;
  bool HighestIsPole = false;
  std::vector<lms3dGridLine> RowLines;
  std::vector<lms3dGridLine> ColumnLines;
  /// All rows of the scan.
  std::vector<RowRun> RowRuns;
  std::vector<double> Cosines;
  std::vector<double> Sines;
  std::vector<double> Tangents;
  /// The lowest elevation, radians, and the rows per radian.
  double LowestElevation = 0.0;
  double RowDensity = 0.0;
  std::vector<double> Azimuths;
  std::vector<std::array<double, 2>> Horizontals;
  lms3dBeamVector<double> Ranges;
  std::vector<double> PoleHalfSpreads;
  /// By grid index. Empty if there are none.
  std::vector<std::uint8_t> Filled;
  /// Null if beams are regular; then the arrays after it are empty.
  std::unique_ptr<lms3dBeamRays> Rays;
  std::vector<lms3dVector> Directions;
  lms3dBeamVector<double> RangesOnBeams;
  std::vector<lms3dVector> PointsBeyondAxis;
  int InterlacedRows = 1;
  std::vector<std::uint8_t> Joins;
};

#endif
