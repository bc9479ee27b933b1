// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The starts and directions of the beams of lms3dBeamSphere, if these are not regular.
 */
#ifndef lms3dBeamRays_h
#define lms3dBeamRays_h

#include "LocalMap/Grid/lms3dMapGeometry.h"
#include "LocalMap/Patches/lms3dGridLines.h"

#include <cstddef>
#include <vector>

/// One ray for each entry of the sphere. Entries of the halo continue the nearest beam and the
/// nearest turn. Beyond the last row, at the pole, the halo is the axis.
class lms3dBeamRays
{
public:
  lms3dBeamRays(const lms3dMapGeometry& geometry, const std::vector<lms3dGridLine>& rows,
    const std::vector<lms3dGridLine>& columns);

  const lms3dMapRay& operator[](std::size_t index) const { return this->Rays[index]; }

  /// Replaces a ray by the axis, upwards or downwards as the ray points.
  void SetToAxis(std::size_t index);

  /// Whether a ray is vertical, as the axis is.
  bool IsVertical(std::size_t index) const
  {
    return this->Rays[index].Direction[0] == 0.0 && this->Rays[index].Direction[1] == 0.0;
  }

  /// The largest distance of a start from the axis, metres.
  double GetLargestOffset() const { return this->LargestOffset; }

  /// The largest angle between a beam and the angle of its column, radians, seen along the axis.
  double GetLargestTurn() const { return this->LargestTurn; }

private:
  void MakeColumn(const lms3dMapGeometry& geometry, int turn, double degrees,
    const std::vector<lms3dGridLine>& rows);

  /// By column, then by row.
  std::vector<lms3dMapRay> Rays;
  double LargestOffset;
  double LargestTurn;
};

#endif
