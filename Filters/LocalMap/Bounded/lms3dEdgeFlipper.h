// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Flips the edges of a map so that it fits the returns better.
 */
#ifndef lms3dEdgeFlipper_h
#define lms3dEdgeFlipper_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Two triangles with an edge in common form a quadrilateral. A flip replaces this diagonal by the
 * other one (Hoppe et al. 1993, "Mesh optimization", edge swap). Vertices stay where they are, and
 * the number of triangles stays the same. On a curved surface, one of the diagonals is nearer to
 * the returns.
 *
 * Only edges where edges have collapsed (lms3dEdgeCollapser), so on curved or noisy surfaces, are
 * looked at, and none if that is less than a quarter of the triangles. An edge between two
 * triangles of one patch is flipped if the sensor sees a convex quadrilateral, if all returns on
 * it stay within the bound, and if the sum of their squared distances
 * (lms3dTriangleBeams::GetSum) becomes smaller by a twentieth. Borders and triangles that join
 * patches along an offset stay.
 *
 * Edges are flipped in rounds, those that gain most first. Flips of one round have no triangle in
 * common. The threads divide the triangles to find them, and the result does not depend on the
 * number of threads. Each flip makes the sum over all triangles smaller, so the rounds end.
 */
class lms3dEdgeFlipper
{
public:
  /// Keeps references. `patchIds` are the patches of the triangles, `maximumError` is the bound,
  /// metres.
  lms3dEdgeFlipper(const lms3dBeamDemands& demands, const std::vector<std::int32_t>& patchIds,
    double maximumError, lms3dVertexStars& stars);

  /// Flips edges until a round finds none. Returns 1 for the corners of each quadrilateral that has
  /// changed and for their neighbours, and 0 for other vertices, by vertex; empty if no edge was
  /// flipped. Uses the threads of the calling TBB arena.
  std::vector<std::uint8_t> Run();

private:
  using Quad = lms3dVertexStars::Quad;

  struct Flip
  {
    /// How much smaller the sum becomes. 0 stands for no flip.
    double Gain = 0.0;
    Quad Edge = {};
  };

  void AddNeighbors(std::vector<std::uint8_t>& isChosen) const;
  void MarkChanged(std::int32_t triangle)
  {
    this->IsChanged[triangle] = 1;
    this->Changed.push_back(triangle);
  }
  std::vector<Flip> FindFlips() const;
  Flip FindBestFlip(std::int32_t triangle) const;
  bool FindQuad(std::int32_t triangle, int corner, Quad& quad) const;
  bool CanFlip(const Quad& quad) const;
  bool AreNeighbors(std::int32_t a, std::int32_t b) const;
  double GetChange(const Quad& quad) const;
  double GetGain(const Quad& quad) const;
  bool MakeFlips(const std::vector<Flip>& flips, std::vector<std::uint8_t>& isAtFlip);

  const lms3dVector& GetDirection(std::int32_t vertex) const
  {
    return this->Stars.GetVertex(vertex).Corner.Position;
  }

  const lms3dBeamDemands& Demands;
  const std::vector<std::int32_t>& PatchIds;
  const double MaximumError;
  lms3dVertexStars& Stars;
  ///@{
  /// The triangles that the last round has changed, at first those that edge collapses have
  /// changed. Then the same by triangle, 1 or 0.
  std::vector<std::int32_t> Changed;
  std::vector<std::uint8_t> IsChanged;
  ///@}
};

#endif
