// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which returns of a pole one vertex can represent, and facets for the others.
 */
#ifndef lms3dPoleRanges_h
#define lms3dPoleRanges_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <cstdint>
#include <vector>

/**
 * The beams of all turns coincide at a pole, so their returns become one vertex. The vertex
 * represents as many returns as possible: all returns if their ranges span at most twice the error
 * bound, otherwise those within the bound of the median. The other returns get facets, each for as
 * many returns as are within the bound of its range.
 */
class lms3dPoleRanges
{
public:
  /// Gives each pole of the sphere the range of its vertex. See lms3dBeamSphere::SetPole().
  /// `maximumError` is metres. Keeps a reference to the sphere.
  lms3dPoleRanges(const lms3dRangeGrid& grid, double maximumError, lms3dBeamSphere& sphere);

  /// Adds the facets of all poles to a map that has their vertices, and counts the returns of the
  /// poles and their deviations.
  void AddTo(lms3dBoundedMap& map) const;

private:
  struct Pole
  {
    lms3dBeamSphere::GridIndex Index;
    /// Metres, growing: the returns that the vertex represents, and the others.
    std::vector<double> Near;
    std::vector<double> Others;
  };

  void AddFacets(const Pole& pole, lms3dBoundedMap& map) const;

  const lms3dBeamSphere& Sphere;
  const double MaximumError;
  std::vector<Pole> Poles;
};

#endif
