// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of some turns: the step from ranges of beams to points and arrays.
 */
#ifndef lms3dTurnReturns_h
#define lms3dTurnReturns_h

#include "Device/lms3dBeams.h"
#include "Device/lms3dReturns.h"
#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <vtkType.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The hits of a scan. Pointers and references must outlive it. Ranges, Triangles and Cells have
/// one value for each beam, ordered by turn, then by beam.
struct lms3dTurnReturns
{
  /// Fills the slots of the returns of the turns from `begin` up to, but not including, `end`, in
  /// the arrays and in `cellIds`. `slots` has the slot of the first return of each turn of the
  /// scan, and the number of returns at the end. Several turns in one call take less time than one
  /// by one.
  void Fill(int begin, int end, const std::vector<std::size_t>& slots, const lms3dReturns& returns,
    vtkIdType* cellIds) const;

  const lms3dScanGeometry& Geometry;
  const lms3dBeamDirections& Directions;

  /// Null if the platform is centred and stepped (lms3dPlatform.h).
  const lms3dBeams* Beams;

  /// The sensor's position in world coordinates, metres.
  const std::array<double, 3>& Position;

  /// Metres. Used only for beams with a return.
  const double* const Ranges;

  /// lms3dBeamPacket::NoTriangle if the beam gave no return.
  const std::int32_t* const Triangles;

  /// Maps triangles to cells. If null, Cells has the cells.
  const lms3dTriangleMesh* const Mesh;
  const vtkIdType* const Cells;
};

#endif
