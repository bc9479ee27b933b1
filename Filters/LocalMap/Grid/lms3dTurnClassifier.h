// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Applies lms3dDepthStep to neighbours in the direction of the turns.
 */
#ifndef lms3dTurnClassifier_h
#define lms3dTurnClassifier_h

#include "LocalMap/Grid/lms3dDepthStep.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <algorithm>
#include <array>
#include <vector>

/**
 * Finds the tilt of planes along turns, 1/metre, which lms3dDepthStep needs at elevations other than 0.
 * The plane passes through a return, a return beside it in the fan, and a return in the next turn.
 */
class lms3dTiltFinder
{
public:
  /// Keeps a reference to `fanStep`, which decides whether neighbours in a fan lie on one surface.
  lms3dTiltFinder(const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep);

  /// The tilt at a return. `ranges` belong to its turn, with the halo of lms3dRangeGrid. 0, as for an
  /// upright plane, if the return beside it is not on its surface.
  double Find(const double* ranges, int beam) const
  {
    const auto& [neighbor, ofRange, ofNeighbor] = this->Weights[beam];
    const double* first = ranges + std::min(beam, neighbor);
    return neighbor != NoNeighbor && this->FanStep.Classify(first) == lms3dDepthStep::Joined
      ? ofRange / ranges[beam] + ofNeighbor / ranges[neighbor]
      : 0.0;
  }

private:
  static constexpr int NoNeighbor = -1;

  /// The tilt is OfRange / range + OfNeighbor / range of the neighbour.
  struct TiltWeights
  {
    int Neighbor;
    double OfRange;
    double OfNeighbor;
  };

  static TiltWeights GetWeights(const lms3dScanGeometry& geometry, int beam, double scale);

  const lms3dDepthStep& FanStep;
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
    : Step(step)
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
    // Most neighbours are equal.
    if (this->Step.AreRangesEqual(this->Rows[2][beam], this->Rows[3][beam]))
    {
      return lms3dDepthStep::Joined;
    }
    const auto [earlier, before, a, b, after, later] = this->GetRanges(beam);
    if (!(a > 0.0 && b > 0.0))
    {
      return lms3dDepthStep::Separate;
    }
    const double tiltOfA = this->Tilts.Find(this->Rows[2], beam);
    const double tiltOfB = this->Tilts.Find(this->Rows[3], beam);
    if (this->Step.AreCoplanar(before, a, b, after, tiltOfA, tiltOfB))
    {
      return lms3dDepthStep::Joined;
    }
    if (!this->Step.DoPlanesIntersect(before, a, b, after, tiltOfA, tiltOfB))
    {
      return lms3dDepthStep::Separate;
    }
    const bool isStraight = a < b
      ? this->Step.IsStraight(earlier, before, a, this->FindTilt(1, beam))
      : this->Step.IsStraight(later, after, b, this->FindTilt(4, beam));
    return isStraight ? lms3dDepthStep::Joined : lms3dDepthStep::Uncertain;
  }

private:
  // From two turns before the first neighbour to two after the second.
  static constexpr int NumberOfRows = 6;

  std::array<double, NumberOfRows> GetRanges(int beam) const
  {
    return { this->Rows[0][beam], this->Rows[1][beam], this->Rows[2][beam], this->Rows[3][beam],
      this->Rows[4][beam], this->Rows[5][beam] };
  }

  double FindTilt(int row, int beam) const
  {
    return this->Rows[row][beam] > 0.0 ? this->Tilts.Find(this->Rows[row], beam) : 0.0;
  }

  const lms3dDepthStep& Step;
  const lms3dTiltFinder& Tilts;
  std::array<const double*, NumberOfRows> Rows;
};

#endif
