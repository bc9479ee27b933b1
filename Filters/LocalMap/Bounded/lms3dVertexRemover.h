// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Removes the vertices of a map that the bound does not need.
 */
#ifndef lms3dVertexRemover_h
#define lms3dVertexRemover_h

#include "LocalMap/Bounded/lms3dVertexMoves.h"
#include "LocalMap/Bounded/lms3dVertexQueue.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * A vertex moves into a neighbour and vanishes if the rules (lms3dVertexMoves) allow it. A vertex
 * on the border of the surface moves along the border, and a vertex at an offset along the line of
 * its patch. Other vertices stay where they are.
 *
 * Vertices move in rounds, the cheapest first. The stars of one round have no vertex in common, so
 * the threads divide them, and the result does not depend on the number of threads.
 */
class lms3dVertexRemover
{
public:
  /// Keeps references.
  lms3dVertexRemover(const lms3dVertexMoves& moves, lms3dVertexStars& stars);

  /// Removes vertices until none can move. Returns false if none can. Uses the threads of the
  /// calling TBB arena.
  bool Run();

private:
  static constexpr std::int32_t None = -1;

  /// A neighbour, and the square of its distance as the sensor sees it.
  struct Target
  {
    double Distance;
    std::int32_t Vertex;

    bool operator<(const Target& other) const
    {
      return this->Distance != other.Distance ? this->Distance < other.Distance
                                              : this->Vertex < other.Vertex;
    }
  };

  /// The number of neighbours that a vertex tries to move to.
  static constexpr std::size_t MaximumTargets = 6;

  /// The nearest targets, sorted.
  struct Targets
  {
    void Add(const Target& target);
    const Target* begin() const { return this->Nearest.data(); }
    const Target* end() const { return this->Nearest.data() + this->Size; }

    /// One more than remain.
    std::array<Target, MaximumTargets + 1> Nearest;
    std::size_t Size = 0;
  };

  /// A vertex that may move.
  struct Candidate
  {
    double Cost = 0.0;
    lms3dVertexStars::Border Border;
    /// The border of the surface or, at an offset, of the patch. The vertex moves along it.
    lms3dVertexStars::Border Line;
    /// The neighbour that the vertex moves to, or None.
    std::int32_t To = None;
    /// Whether the star has changed since Prepare() looked at it.
    bool IsStarChanged = true;
    /// Whether the vertex lies inside of a patch. Moves of others do not change that.
    bool IsInside = false;
    /// Whether the vertex cannot leave its line.
    bool IsFixed = false;
    /// Whether it could move to no neighbour. This holds until its star changes: its neighbours get
    /// only more neighbours in common with it.
    bool HasFailed = false;
  };

  void Prepare(std::int32_t vertex);
  void LookAtStar(std::int32_t vertex);
  bool FindLine(std::int32_t vertex, Candidate& candidate) const;
  bool MayLeaveLine(std::int32_t vertex, const Candidate& candidate) const;
  double GetCostOnLine(std::int32_t vertex, const lms3dVertexStars::Border& line) const;
  double GetCostInside(std::int32_t vertex) const;
  void UpdateQueue();
  void TryToMove(std::int32_t vertex);
  Targets FindTargets(std::int32_t vertex) const;
  double GetSmallestHeight(std::int32_t vertex) const;
  bool CanMove(std::int32_t from, std::int32_t to, double minimumHeight) const;
  bool HasSoundShape(std::int32_t from, std::int32_t to, double minimumHeight) const;
  bool AreLinked(std::int32_t from, std::int32_t to) const;
  void Move(std::int32_t vertex, std::int32_t to);
  void CollectChanged(const std::vector<std::int32_t>& vertices);

  const lms3dVector& GetDirection(std::int32_t vertex) const
  {
    return this->Stars.GetVertex(vertex).Corner.Position;
  }

  const lms3dVertexMoves& Moves;
  lms3dVertexStars& Stars;
  /// By vertex.
  std::vector<Candidate> Candidates;
  /// The vertices whose stars may have changed in a round.
  std::vector<std::int32_t> Changed;
  lms3dVertexQueue Queue;
};

#endif
