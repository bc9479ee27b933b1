// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collapses the edges of a map that the bound does not need.
 */
#ifndef lms3dEdgeCollapser_h
#define lms3dEdgeCollapser_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dCollapsibleEdges.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

/**
 * Edges collapse in rounds, the cheapest first (lms3dCollapsibleEdges). The stars of one round's
 * edges have no vertex in common. A collapse changes only its stars, and it reads nothing that
 * another collapse changes. So the threads divide the edges, and the result does not depend on the
 * number of threads.
 */
class lms3dEdgeCollapser
{
public:
  /// Collapses edges until no edge with a free end can collapse within the bound, or, in large
  /// maps, until hardly any can. Returns false if none can. Uses the threads of the calling TBB
  /// arena.
  static bool Run(const lms3dBeamDemands& demands, lms3dVertexStars& stars);

private:
  using Edge = lms3dCollapsibleEdges::Edge;

  struct Result
  {
    bool CanCollapse;
    lms3dVector Direction;
    double Inverse;
  };

  static bool HasSoundShape(
    const lms3dVertexStars& stars, const Edge& edge, const lms3dTriangleCorner& corner);
  static Result TryToCollapse(
    const lms3dVertexStars& stars, const lms3dBeamDemands& demands, const Edge& edge);
  static bool Collapse(const lms3dBeamDemands& demands, const Edge& edge, lms3dVertexStars& stars);
};

#endif
