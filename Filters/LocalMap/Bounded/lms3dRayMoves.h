// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides which moves of a vertex are allowed if beams are not regular.
 */
#ifndef lms3dRayMoves_h
#define lms3dRayMoves_h

#include "LocalMap/Bounded/lms3dVertexMoves.h"
#include "LocalMap/Patches/lms3dBeamSphere.h"

#include <vector>

/**
 * Casts the beams at the triangles before and after a move. Each return that a triangle explained
 * must be explained after the move, and no beam may meet a triangle in front of its return where
 * there was none. The border of the surface stays: beams pass it at an angle.
 */
class lms3dRayMoves : public lms3dVertexMoves
{
public:
  /// Keeps a reference. `maximumError` is the bound, metres.
  lms3dRayMoves(const lms3dBeamSphere& sphere, double maximumError)
    : Sphere(sphere)
    , MaximumError(maximumError)
  {
  }

  bool MayLeaveBorder(
    const lms3dVertexStars&, std::int32_t, std::int32_t, std::int32_t) const override
  {
    return false;
  }
  bool MayLeaveOffset(
    const lms3dVertexStars&, std::int32_t, std::int32_t, std::int32_t) const override
  {
    return true;
  }
  bool KeepsBound(const lms3dVertexStars& stars, std::int32_t from, std::int32_t to) const override;

  /// The largest distance of a return from the nearest triangle that explains it, metres.
  double GetLargestDeviation(const lms3dBoundedMap& map) const;

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// The beams that hit some triangles, sorted.
  struct Hits
  {
    /// Those with a return within the bound of the hit, and those that the hit blocks.
    std::vector<GridIndex> Explained;
    std::vector<GridIndex> Blocked;

    void Sort();
  };

  void Cast(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c, Hits& hits) const;
  template <typename Visitor>
  void ForEachBeam(
    const lms3dVector& a, const lms3dVector& b, const lms3dVector& c, const Visitor& visit) const;

  const lms3dBeamSphere& Sphere;
  const double MaximumError;
};

#endif
