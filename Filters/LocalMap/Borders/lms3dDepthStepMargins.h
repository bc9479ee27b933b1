// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the range of the surface may change beyond the last return before a depth step.
 */
#ifndef lms3dDepthStepMargins_h
#define lms3dDepthStepMargins_h

#include "LocalMap/Patches/lms3dPatches.h"

/// See lms3dRangeSupport. Changes and margins are metres.
class lms3dDepthStepMargins
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// The share of the range's last change by which it may go on changing up to a depth step.
  static constexpr double ShareOfSlope = 0.5;

  /// Keeps references. `tolerance` is that of lms3dBorderGates, metres.
  lms3dDepthStepMargins(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance)
    : Sphere(sphere)
    , Patches(patches)
    , Tolerance(tolerance)
  {
  }

  /// The margin at the gate on a side of a return, an lms3dBeamSphere::Side. The margins of both
  /// sides of a depth step leave half of the step open, for any tolerance.
  double GetMargin(GridIndex own, int side) const;

  /// The change of range from the neighbour behind a return to the return, along the way to a side.
  /// 0 if the neighbour is not joined or not in the patch.
  double GetSlope(GridIndex index, int side) const;

  /// The same change as the patch's plane predicts it. 0 if the plane rests on few returns.
  double GetSlopeOfPlane(GridIndex index, int side) const;

private:
  bool HasSlope(GridIndex index, int back) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const double Tolerance;
};

#endif
