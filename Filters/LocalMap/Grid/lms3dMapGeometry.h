// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The grid in which a scan of any platform is mapped.
 */
#ifndef lms3dMapGeometry_h
#define lms3dMapGeometry_h

#include "Device/lms3dFan.h"
#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

#include <array>
#include <vector>

/// A beam in the frame of the map, metres.
struct lms3dMapRay
{
  lms3dVector Origin;
  lms3dVector Direction;
};

/**
 * The map's frame has the axes F(0), S(0) and A of the platform (lms3dPlatform.h) as x, y and z.
 * Its origin is the point of the axis at the height of the mirror's centre. In this frame, the grid
 * of the map is that of the mounting Yawing: rows are elevations, and columns are platform angles.
 *
 * If the middle of the fan lies on the axis, each half of the fan becomes a turn of its own, whose
 * elevations end at the pole: beams at alpha > 0 belong to the turn beta, and beams at alpha < 0 to
 * the turn beta + 180. A beam at alpha 0 is the pole. Turns at 180 degrees or more from the first
 * one repeat directions and have no place in the grid. Between the turns of both sides, the grid
 * gets turns without returns where turns are missing.
 *
 * Beams are regular if all start at the origin, at the elevation of their row and the angle of
 * their column. They are not if the mirror's centre lies beside the axis, if the platform turns
 * during a fan, or if the two halves of a fan along the axis have different elevations.
 */
class lms3dMapGeometry
{
public:
  static constexpr int NoBeam = -1;

  /// Throws std::runtime_error, with a text for the user, if the angles of a fan along the axis are
  /// not strictly monotonic, or if the grid would be too large.
  explicit lms3dMapGeometry(const lms3dScanGeometry& scanned);

  /// The grid of the scan.
  const lms3dScanGeometry& GetScanned() const { return this->Scanned; }

  /// The grid of the map.
  const lms3dScanGeometry& GetGrid() const { return this->Grid; }

  /// Whether both grids have the same turns and beams.
  bool IsAsScanned() const { return !this->IsUnfolded; }

  bool IsRegular() const { return this->Regular; }

  /// The distance of the mirror's centre from the axis, metres.
  double GetDistanceFromAxis() const;

  /// The height of the mirror's centre along the axis, metres.
  double GetHeight() const { return this->Height; }

  /// The BeamId in the grid of the map, or NoBeam if the beam's turn repeats another. `beamId` must
  /// lie in the grid of the scan.
  int GetBeamId(int beamId) const;

  /// Whether the point at a range of a beam, metres, lies behind the axis, where the beams of other
  /// turns measure as well. Beams pass the axis if the mirror's centre lies behind it.
  bool IsBeyondAxis(int turn, int beam, double range) const;

  /// Any beam of the map's grid, and beams that no turn has measured.
  lms3dMapRay GetRay(int turn, int beam) const;

  /// How far the platform has turned when each beam of a turn leaves, in steps from turn to turn.
  /// Null if it stands still.
  const double* GetTurnedSteps(int turn) const;

  /// The first turn of the second half if the halves of the fans do not continue each other,
  /// because the mirror lies beside the plane of its fan's halves; otherwise 0.
  int GetSeam() const
  {
    return this->IsUnfolded && this->Grid.GetPlatform().AxisOffset[1] != 0.0 ? this->TurnsOfHalf
                                                                             : 0;
  }

  /// In a fan, beams that many apart leave in the same turn of the mirror. 1 if the platform stands
  /// still.
  int GetInterlacedBeams() const;

private:
  /// One of the two halves of a fan, or all of it.
  struct Half
  {
    /// The beams of the scan, for each beam of the grid; NoBeam if there is none.
    std::vector<int> Beams;
    std::vector<double> TurnedSteps;
  };

  static lms3dScanGeometry MakeGrid(const lms3dScanGeometry& scanned, std::array<Half, 2>& halves,
    int& turnsOfHalf, bool& isRegular);
  void FillTurnedSteps(Half& half) const;
  int GetHalf(int turn) const { return this->IsUnfolded && turn >= this->TurnsOfHalf ? 1 : 0; }

  const lms3dScanGeometry Scanned;
  const bool IsUnfolded;
  std::array<Half, 2> Halves;
  /// The turns of the grid on each side of the axis.
  int TurnsOfHalf = 0;
  bool Regular = true;
  const lms3dScanGeometry Grid;
  const lms3dFan Fan;
  double Height;
  /// For each beam of the scan: its half, and its beam in the grid.
  std::vector<std::array<int, 2>> Places;
};

#endif
