// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A region of a fused map: a plane, what scans know about it, and its triangles.
 */
#ifndef lms3dFusedPlane_h
#define lms3dFusedPlane_h

#include "Fusion/lms3dFusedMesh.h"
#include "Fusion/lms3dLocalMap.h"
#include "Fusion/lms3dPlaneFrame.h"
#include "Fusion/lms3dRaster.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

/// A part of the line in which two planes meet, from `first` to `second`, metres along the line's direction.
using lms3dCreaseParts = std::vector<std::pair<double, double>>;

struct lms3dFusedPlane
{
  explicit lms3dFusedPlane(const lms3dPlaneFrame& frame)
    : Frame(frame)
  {
  }

  /// Returns whether a return lies within `bound`, metres, of the plane, and the plane is not nearer than the
  /// return by more, along the beam.
  bool Explains(const lms3dVector& point, const lms3dVector& direction, double bound) const
  {
    const double height = this->Frame.GetHeight(point);
    const double cosine = -lms3dDot(this->Frame.GetNormal(), direction);
    return height >= 0.0 ? height <= bound : -height <= bound * cosine;
  }

  lms3dPlaneFrame Frame;
  lms3dRaster Raster;
  /// Whether the surface is curved.
  bool IsCurved = false;
  /// Whether few returns support the plane, so that a better view may take its place. Its returns are then kept.
  bool IsWeak = false;
  std::vector<lms3dMappedReturn> Returns;
  /// The creases with other planes, by their numbers.
  std::map<int, lms3dCreaseParts> Creases;
  /// The triangle of a local map, if the region is nothing else. It need not lie exactly in the plane.
  std::vector<std::array<lms3dVector, 3>> Verbatim;
  /// World coordinates.
  lms3dVector Low = { 1e300, 1e300, 1e300 };
  lms3dVector High = { -1e300, -1e300, -1e300 };

  /// Whether the mesh does not explain what scans saw.
  bool IsChanged = true;
  /// Whether the last scan has returns here.
  bool IsSeen = true;
  int Revision = 0;
  /// Blocks before this one are not new.
  int OldBlocks = 0;
  lms3dFusedMesh Mesh;
};

#endif
