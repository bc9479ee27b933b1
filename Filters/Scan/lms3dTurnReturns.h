// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of one turn: the step from ranges of beams to points and arrays.
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

/// The input of one turn. Pointers and references must outlive it. Ranges, Triangles and Cells have
/// one value for each beam of the turn.
struct lms3dTurn
{
  /// Fills the slots of the turn's returns, from `slot` on, in the arrays and in `cellIds`. `count`
  /// is the number of beams with a return.
  void Fill(std::size_t slot, int count, const lms3dReturns& returns, vtkIdType* cellIds) const;

  const lms3dScanGeometry& Geometry;
  const lms3dBeamDirections& Directions;

  /// Null if the platform is centred and stepped (lms3dPlatform.h).
  const lms3dBeams* Beams;

  /// The sensor's position in world coordinates, metres.
  const std::array<double, 3>& Position;

  /// The number of the turn, from 0.
  const int Number;

  /// Metres. Used only for beams with a return.
  const double* const Ranges;

  /// lms3dBeamPacket::NoTriangle if the beam gave no return.
  const std::int32_t* const Triangles;

  /// Maps triangles to cells. If null, Cells has the cells.
  const lms3dTriangleMesh* const Mesh;
  const vtkIdType* const Cells;
};

#endif
