// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Applies lms3dDepthStep to neighbours in the direction of the turns.
 */
#ifndef lms3dTurnClassifier_h
#define lms3dTurnClassifier_h

#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dPaddedGrid.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/**
 * Finds the tilt of planes along turns, 1/metre, which lms3dDepthStep needs at elevations other
 * than 0. The plane passes through a return, a return beside it in the fan, and a return in the
 * next turn.
 */
class lms3dTiltFinder
{
public:
  /// Keeps a reference to `fanStep`, which decides whether neighbours in a fan lie on one surface.
  /// `areFansSteady` is whether the platform stands still during a fan.
  lms3dTiltFinder(
    const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep, bool areFansSteady);

  /// Takes the neighbours in a fan that lie on one surface from flags, which is faster: not 0 for
  /// each beam that lies on one surface with the next. Keeps a reference.
  void SetFans(const lms3dPaddedGrid<std::uint8_t>& fans) { this->Fans = &fans; }

  /// The tilt at a return. `ranges` belong to its turn, with the halo of lms3dRangeGrid. If the
  /// return beside it is not on its surface, the tilt is anything between 0, as for an upright
  /// plane, and that through both returns. If fans are not steady, it is then 0.
  lms3dDepthStep::Tilt Find(int turn, const double* ranges, int beam) const;

private:
  static constexpr int NoNeighbor = -1;

  /// The tilt is OfRange / range + OfNeighbor / range of the neighbour.
  struct TiltWeights
  {
    int Neighbor;
    double OfRange;
    double OfNeighbor;
  };

  bool IsOneSurface(int turn, const double* ranges, int beam) const;
  static TiltWeights GetWeights(const lms3dScanGeometry& geometry, int beam, double scale);

  const lms3dDepthStep& FanStep;
  const bool AreFansSteady;
  const lms3dPaddedGrid<std::uint8_t>* Fans = nullptr;
  /// By beam.
  std::vector<TiltWeights> Weights;
};

/// Decides whether the beams of a turn lie on one surface with the same beams of the next turn.
class lms3dTurnClassifier
{
public:
  /// Keeps references. Reads the turns `turn` - 2 to `turn` + 3 of the grid.
  lms3dTurnClassifier(
    const lms3dRangeGrid& grid, int turn, const lms3dDepthStep& step, const lms3dTiltFinder& tilts)
    : Turn(turn)
    , Step(step)
    , Tilts(tilts)
  {
    for (int i = 0; i < NumberOfRows; ++i)
    {
      this->Rows[i] = grid.GetRanges(turn - 2 + i);
    }
  }

  /// The relation of a beam to the same beam of the next turn.
  lms3dDepthStep::Relation Classify(int beam) const
  {
    const double range = this->Rows[2][beam];
    const double next = this->Rows[3][beam];
    // Most neighbours are near.
    if (this->Step.AreNear(range, next))
    {
      return lms3dDepthStep::Joined;
    }
    return range > 0.0 && next > 0.0
      ? this->Step.Classify(this->GetSideBefore(beam), this->GetSideBehind(beam))
      : lms3dDepthStep::Separate;
  }

  /// Sets a flag for each beam that is near the same beam of the next turn
  /// (lms3dDepthStep::AreNear). These are Joined.
  void FlagNear(int beams, std::uint8_t flag, std::uint8_t* flags) const
  {
    this->Step.FlagNear(this->Rows[2], this->Rows[3], beams, flag, flags);
  }

  ///@{
  /// The sides of a beam and of the same beam of the next turn.
  lms3dDepthStep::Side GetSideBefore(int beam) const { return this->GetSide(beam, 2, -1); }
  lms3dDepthStep::Side GetSideBehind(int beam) const { return this->GetSide(beam, 3, 1); }
  ///@}

private:
  // From two turns before the first neighbour to two after the second.
  static constexpr int NumberOfRows = 6;

  lms3dDepthStep::Side GetSide(int beam, int row, int backwards) const
  {
    const int before = row + backwards;
    return { { this->Rows[row][beam], this->Rows[before][beam],
               this->Rows[before + backwards][beam] },
      { this->Tilts.Find(this->Turn - 2 + row, this->Rows[row], beam),
        this->Tilts.Find(this->Turn - 2 + before, this->Rows[before], beam) } };
  }

  const int Turn;
  const lms3dDepthStep& Step;
  const lms3dTiltFinder& Tilts;
  std::array<const double*, NumberOfRows> Rows;
};

#endif
