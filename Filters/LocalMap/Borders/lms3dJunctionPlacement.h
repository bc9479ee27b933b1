// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The position of a junction inside its cell.
 */
#ifndef lms3dJunctionPlacement_h
#define lms3dJunctionPlacement_h

#include "LocalMap/Borders/lms3dBorderGates.h"
#include "LocalMap/Borders/lms3dBorderRanges.h"

#include <array>

/**
 * Moves a junction (see the figure in lms3dBorderGates.h) from the middle of its cell to the
 * nearest point at which the creases of the cell meet (lms3dCreaseIntersection). If offsets divide
 * a cell into several junctions, all of them move together, so that the strips between them do not
 * flip; they stand apart by a fixed share of the cell.
 */
class lms3dJunctionPlacement
{
public:
  using Cell = lms3dBorderGates::Cell;

  /// Keeps references.
  lms3dJunctionPlacement(const lms3dBeamSphere& sphere, const lms3dPatches& patches,
    const lms3dBorderGates& gates, const lms3dBorderRanges& borderRanges)
    : Sphere(sphere)
    , Patches(patches)
    , Gates(gates)
    , BorderRanges(borderRanges)
  {
  }

  /// The vertex of the junction that some corners of a cell share, given as bits, at least one. If
  /// `staysInMiddle`, the junction does not move to the creases.
  lms3dMapVertex Locate(const Cell& cell, int corners, bool staysInMiddle) const;

private:
  std::array<double, 4> FindWeights(const Cell& cell, int corners, bool staysInMiddle) const;
  std::array<double, 4> GetDifferences(const Cell& cell, int corner) const;
  bool IsWide(const Cell& cell) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dBorderRanges& BorderRanges;
};

#endif
