// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Why each beam of the map's grid has a return or none, and which beams are neighbours.
 */
#ifndef lms3dBeamStates_h
#define lms3dBeamStates_h

#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * A place is a beam of the map's grid: turn * number of beams + beam. A pole has one place, in turn
 * 0.
 *
 * Turns of a closed scan go on in a circle. There are no neighbours across a seam between halves of
 * fans that do not continue each other (lms3dMapGeometry).
 */
class lms3dBeamStates
{
public:
  enum State : std::uint8_t
  {
    /// Not measured, beyond the scan, or a return beyond the axis.
    Outside,
    /// There is nothing along the beam.
    Free,
    /// No return, and it is not known why.
    Missing,
    Returned,
    /// A return that the surface may leave out.
    Speckle
  };

  static constexpr int NoPlace = -1;
  static constexpr int NoBeam = -1;

  /// Keeps references. `isFree` says for each BeamId of the scan whether there is nothing along the
  /// beam; it is empty if that is not known. Uses the threads of the calling TBB arena.
  lms3dBeamStates(
    const lms3dRangeGrid& grid, const lms3dMapGeometry& geometry, const std::vector<bool>& isFree);

  int GetSize() const { return static_cast<int>(this->States.size()); }
  int GetNumberOfTurns() const { return this->Turns; }
  int GetNumberOfBeams() const { return this->Beams; }
  int GetTurn(int place) const { return place / this->Beams; }
  int GetBeam(int place) const { return place % this->Beams; }
  bool IsPole(int place) const { return this->IsPoleBeam[this->GetBeam(place)]; }

  State GetState(int place) const { return place == NoPlace ? Outside : this->States[place]; }
  void SetState(int place, State state) { this->States[place] = state; }

  /// The range along each beam of a turn, metres; 0 without a return.
  const double* GetRanges(int turn) const { return this->Grid.GetRanges(turn); }
  /// The same of one beam.
  double GetRange(int place) const
  {
    return this->Grid.GetRange(this->GetTurn(place), this->GetBeam(place));
  }

  /// The BeamId in the scan. The place must have been measured.
  int GetBeamId(int place) const { return this->BeamIds.empty() ? place : this->BeamIds[place]; }

  lms3dMapRay GetRay(int place) const;

  /// Whether the point at a range of a beam, metres, lies behind the axis.
  bool IsBeyondAxis(int place, double range) const;

  /// The eight neighbours of a place that is not a pole, or NoPlace for each that does not exist.
  /// Those beside the place in its fan or in its turn come first. A pole may occur several times.
  std::array<int, 8> GetNeighbors(int place) const;

private:
  void FillMeasured(const std::vector<bool>& isFree);
  void FillReturns();
  int GetTurnBeside(int turn, int step) const;

  const lms3dRangeGrid& Grid;
  const lms3dMapGeometry& Geometry;
  const int Turns;
  const int Beams;
  /// Whether the mirror lies beside the axis.
  const bool IsBesideAxis;
  std::vector<State> States;
  std::vector<bool> IsPoleBeam;
  /// By place; empty if both grids are the same.
  std::vector<int> BeamIds;
};

#endif
