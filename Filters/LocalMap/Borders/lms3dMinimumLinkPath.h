// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Straightens a border on the sphere of directions.
 */
#ifndef lms3dBorderLine_h
#define lms3dBorderLine_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <vector>

/**
 * A line of few great arcs that passes a row of gates in their order: from each vertex the wedge of
 * directions is followed that passes all gates so far, and the next vertex set in the last gate
 * before the wedge closes (Guibas, Hershberger, Mitchell and Snoeyink 1993, "Approximating polygons
 * and subdivisions with minimum-link paths"; here the vertices lie within gates). As neighbouring
 * gates are sides of one convex cell, the line meets nothing between them.
 */
class lms3dMinimumLinkPath
{
public:
  /// From one beam, left of the line, to one right of it, 0 to 1, and the part that may be passed.
  struct Gate
  {
    lms3dVector Left;
    lms3dVector Right;
    double Low;
    double High;
    double Best;

    lms3dVector GetPoint(double at) const
    {
      return { this->Left[0] + at * (this->Right[0] - this->Left[0]),
        this->Left[1] + at * (this->Right[1] - this->Left[1]),
        this->Left[2] + at * (this->Right[2] - this->Left[2]) };
    }
  };

  /// A vertex in a gate.
  struct Vertex
  {
    int Gate;
    double At;
  };

  explicit lms3dMinimumLinkPath(const std::vector<Gate>& gates)
    : Gates(gates)
  {
  }

  /// The vertices between two points, each in a cell beside the outermost gates; in the first gate
  /// and the last there is one on demand.
  std::vector<Vertex> Straighten(const lms3dVector& start, const lms3dVector& end,
    bool bendsInFirst = false, bool bendsInLast = false) const;

  /// A bend for a line that has none, in the middle of the row, somewhat to the left.
  Vertex GetMiddle(const lms3dVector& start, const lms3dVector& end) const;

  /// Those of a line that closes behind the last gate; at least three.
  std::vector<Vertex> StraightenClosed() const;

private:
  struct Wedge;

  void Append(lms3dVector apex, int first, int count, const lms3dVector& end,
    std::vector<Vertex>& line) const;
  Vertex FindNext(const lms3dVector& apex, int first, int count, int shift, const lms3dVector& end,
    bool& reachesEnd) const;

  const std::vector<Gate>& Gates;
};

#endif
