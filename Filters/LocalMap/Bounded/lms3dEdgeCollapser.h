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

#include <cstddef>

/**
 * Edges collapse in rounds, the cheapest first (lms3dCollapsibleEdges). The stars of one round's
 * edges have no vertex in common. A collapse changes only its stars, and it reads nothing that
 * another collapse changes. So the threads divide the edges, and the result does not depend on the
 * number of threads.
 */
class lms3dEdgeCollapser
{
public:
  /// Collapses edges until no edge with a free end can collapse within the bound. If the surface is
  /// not curved (lms3dSmoothVertices), new triangles must be wider, and a large map ends when
  /// hardly any edge can collapse: few triangles would go, and it would take long. Returns false if
  /// no edge can collapse. Uses the threads of the calling TBB arena.
  static bool Run(const lms3dBeamDemands& demands, bool isCurved, lms3dVertexStars& stars);

private:
  using Edge = lms3dCollapsibleEdges::Edge;

  lms3dEdgeCollapser(const lms3dBeamDemands& demands, bool isCurved, lms3dVertexStars& stars);

  struct Result
  {
    bool CanCollapse;
    lms3dVector Direction;
    double Inverse;
  };

  bool Run();
  bool IsLast(std::size_t selected, std::size_t collapsed) const;
  bool HasSoundShape(const Edge& edge, const lms3dTriangleCorner& corner) const;
  Result TryToCollapse(const Edge& edge) const;
  bool Collapse(const Edge& edge);

  const lms3dBeamDemands& Demands;
  const bool IsCurved;
  lms3dVertexStars& Stars;
};

#endif
