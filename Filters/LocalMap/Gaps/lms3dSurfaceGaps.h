// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the beams of a scan at which its surface goes on, although they have no return on
 * it.
 */
#ifndef lms3dSurfaceGaps_h
#define lms3dSurfaceGaps_h

#include "LocalMap/Gaps/lms3dBeamGroups.h"
#include "LocalMap/Gaps/lms3dBeamStates.h"
#include "LocalMap/Gaps/lms3dSurroundings.h"
#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <cstdint>
#include <vector>

struct lms3dGapSettings
{
  /// The largest group of beams without a return, and the largest speckle, that the surface goes on
  /// behind. 0 for none.
  int MaximumGapSize = 0;
  int MaximumSpeckleSize = 0;
  /// Metres.
  double MaximumError = 0.0;
  double DepthStep = 0.0;
};

/// A beam of a gap or of a speckle.
struct lms3dGapBeam
{
  int Turn;
  int Beam;
  /// In the scan.
  int BeamId;
  /// The number of the gap or of the speckle.
  int Group;
  /// The measured range along the beam, metres; 0 without a return.
  double Range;
  /// Square metres of the plane behind the beam. The beams of a plane share its area.
  double Area;
};

/**
 * A speckle is a group of neighbouring returns (lms3dBeamGroups) that lies off the plane of the
 * returns around it (lms3dSurroundings). It is at one depth, and on no surface with any of them
 * (lms3dRangeJoins), or it stands out of their surface. A gap is a group of neighbouring beams
 * without a return. Both count if they are not too large and if one plane explains the returns
 * around them. The beams of a gap and of a speckle then get the ranges of this plane.
 *
 * A plane explains a return within the share of the error bound that is left to patches, or within
 * four standard deviations of the noise.
 */
class lms3dSurfaceGaps
{
public:
  /// `isFree` says for each BeamId of the scan whether there is nothing along the beam; it is empty
  /// if that is not known. `joins` belong to the grid; without speckles, they are not used. Uses
  /// the threads of the calling TBB arena.
  lms3dSurfaceGaps(const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
    const lms3dMapGeometry& geometry, const lms3dGapSettings& settings,
    const std::vector<bool>& isFree);

  const lms3dGapSettings& GetSettings() const { return this->Settings; }

  /// The beams of all gaps, and of all speckles, group by group.
  const std::vector<lms3dGapBeam>& GetGapBeams() const { return this->GapBeams; }
  const std::vector<lms3dGapBeam>& GetSpeckleBeams() const { return this->SpeckleBeams; }

  /// The ranges of all these beams on the planes around them.
  const std::vector<lms3dFilledBeam>& GetFilledBeams() const { return this->FilledBeams; }

private:
  /// The range and the area of each beam of a group; empty if the surface does not go on behind it.
  struct Filling
  {
    std::vector<double> Ranges;
    std::vector<double> Areas;
  };

  void FindSpeckles(
    const lms3dRangeJoins& joins, lms3dBeamStates& states, const lms3dSurroundings& surroundings);
  void FindGaps(lms3dBeamStates& states, const lms3dSurroundings& surroundings);
  std::vector<Filling> Fill(const lms3dBeamStates& states, const lms3dSurroundings& surroundings,
    const lms3dBeamGroups::Groups& groups) const;
  Filling FillGroup(const lms3dBeamStates& states, const lms3dSurroundings& surroundings,
    const std::vector<int>& group) const;
  double GetArea(
    const lms3dBeamStates& states, int place, const lms3dPlane& plane, double range) const;
  void Append(const lms3dBeamStates& states, const std::vector<int>& group, const Filling& filling,
    int number, std::vector<lms3dGapBeam>& beams);

  const lms3dGapSettings Settings;
  /// The angles between neighbours, radians.
  const double AlphaStep;
  const double BetaStep;
  /// The larger one, degrees.
  const double LargerStep;
  std::vector<lms3dGapBeam> GapBeams;
  std::vector<lms3dGapBeam> SpeckleBeams;
  std::vector<lms3dFilledBeam> FilledBeams;
};

#endif
