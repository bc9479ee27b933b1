// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a scan of one scene from one pose needs before its beams are cast.
 */
#ifndef lms3dScanPlan_h
#define lms3dScanPlan_h

#include "Casting/lms3dGridCaster.h"
#include "Casting/lms3dRayCaster.h"
#include "Device/lms3dScanGeometry.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Scan/lms3dPacketGrid.h"

#include <cstdint>
#include <memory>
#include <vector>

/// Making a plan needs neither memory for the results nor the minimum range.
class lms3dScanPlan
{
public:
  /// Where the sensor stands, in world coordinates, and the maximum range, in metres, are as in
  /// lms3dScanRequest. Uses the threads of the calling TBB arena. Caster and geometry must outlive
  /// each use of the plan, except Fits.
  lms3dScanPlan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, double maximumRange);

  /// Returns whether the plan was made for these arguments. Casters and geometries that took the
  /// place of the plan's do not fit.
  bool Fits(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    double maximumRange) const;

  ///@{
  /// The serial numbers of the caster and of the geometry.
  const std::uint64_t Caster;
  const std::uint64_t Geometry;
  ///@}

  const lms3dPose Pose;
  const lms3dBeamDirections Directions;

  /// One for each column of packets.
  const std::vector<lms3dElevations> Elevations;
  const lms3dRayOrigin Origin;
  const lms3dPacketGrid Grid;
  const std::unique_ptr<const lms3dGridCaster> GridCaster;

private:
  lms3dBeamGrid MakeGrid(const lms3dScanGeometry& geometry) const;
};

#endif
