// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Straightens a border to a path of few great arcs.
 */
#ifndef lms3dMinimumLinkPath_h
#define lms3dMinimumLinkPath_h

#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <vector>

/**
 * Finds a path of few great arcs on the sphere of directions that passes a sequence of gates in
 * order. From each vertex, the path follows the wedge of directions that passes all gates so far;
 * the next vertex lies in the last gate before the wedge closes (Guibas, Hershberger, Mitchell and
 * Snoeyink 1993, "Approximating polygons and subdivisions with minimum-link paths"; here vertices
 * lie in gates). Neighbouring gates are sides of one convex cell, so the path meets nothing between
 * them.
 *
 * Directions are in the sensor frame. Left and right are as the sensor sees the path from its start
 * to its end.
 */
class lms3dMinimumLinkPath
{
public:
  /// A gate of lms3dBorderGates, turned so that it runs from the left of the path to its right.
  /// Positions in it are shares of its chord, 0 at the left.
  struct Gate
  {
    /// The directions of the beams at both ends, of length 1.
    lms3dVector Left;
    lms3dVector Right;
    /// The path must pass between Low and High, and preferably at Best.
    double Low;
    double High;
    double Best;

    /// The point of the chord at a position.
    lms3dVector GetPoint(double at) const
    {
      return lms3dAdd(this->Left, lms3dScale(lms3dSubtract(this->Right, this->Left), at));
    }
  };

  /// A vertex of the path: a gate's number and the position in it.
  struct Vertex
  {
    int Gate;
    double At;
  };

  /// Keeps a reference to at least one gate.
  explicit lms3dMinimumLinkPath(const std::vector<Gate>& gates)
    : Gates(gates)
  {
  }

  /// The vertices between two directions, which lie in the cells before the first and behind the
  /// last gate. They may have any length. The path bends in the first or last gate in any case if
  /// the flags say so.
  std::vector<Vertex> Straighten(const lms3dVector& start, const lms3dVector& end,
    bool bendsInFirst = false, bool bendsInLast = false) const;

  /// A vertex for a path that has none: in the middle gate, left of the straight line.
  Vertex GetMiddle(const lms3dVector& start, const lms3dVector& end) const;

  /// The vertices of a path whose last gate is followed by the first one. At least three if there
  /// are as many gates.
  std::vector<Vertex> StraightenClosed() const;

private:
  struct Wedge;
  struct Rest;
  struct Reach;

  void Append(const lms3dVector& apex, const Rest& rest, std::vector<Vertex>& path) const;
  Vertex Bend(Reach& reach, const Rest& rest) const;
  Reach FindReach(const lms3dVector& apex, const Rest& rest) const;

  const std::vector<Gate>& Gates;
};

#endif
