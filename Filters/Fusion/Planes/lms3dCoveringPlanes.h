// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds planes whose triangles explain returns.
 */
#ifndef lms3dCoveringPlanes_h
#define lms3dCoveringPlanes_h

#include "Fusion/Planes/lms3dFusedPlanes.h"

#include <vector>

/// The returns of a plane are in the order of the beams, so successive ones lie side by side: the
/// planes near one are kept for the next. Until the meshes of the planes are made anew, planes may
/// be made and cleared, and returns may be added.
class lms3dCoveringPlanes
{
public:
  /// Keeps a reference.
  explicit lms3dCoveringPlanes(const lms3dFusedPlanes& planes)
    : Planes(planes)
  {
  }

  /// The first plane within a distance, metres, that covers a return, is met by its beam, and is
  /// not an exception. If there is none, the first one that covers the return with a region, not
  /// with a triangle of a local map or a facet. Otherwise -1.
  int Find(const lms3dMappedReturn& mapped, const std::vector<int>& exceptions, double distance);

private:
  bool Covers(int number, const lms3dMappedReturn& mapped, double distance) const;
  void FindNear(const lms3dVector& point);

  const lms3dFusedPlanes& Planes;
  /// The box around the last point that was searched for, and the planes near the box, in order.
  lms3dWorldBox Box;
  std::vector<int> Near;
};

#endif
