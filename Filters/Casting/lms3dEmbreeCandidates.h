// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles for which Embree only finds candidates, and a test decides which beams hit.
 *
 * Embree's tree is made of boxes, one around each triangle, a little larger than single precision
 * can be wrong. So Embree never rules out a triangle that a beam hits.
 */
#ifndef lms3dEmbreeCandidates_h
#define lms3dEmbreeCandidates_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <memory>

/// Decides which active beams of a packet hit a candidate.
class lms3dCandidateTest
{
public:
  /// Stores the hits of a triangle that are the nearest so far in the packet. Returns the beams that
  /// changed, bit i for beam i. Several threads call this at once.
  virtual std::uint32_t Test(
    const lms3dRayOrigin& origin, std::uint32_t triangle, lms3dBeamPacket& packet) const = 0;

protected:
  ~lms3dCandidateTest() = default;
};

class lms3dEmbreeCandidates
{
public:
  /// Builds the tree of a mesh with at least one triangle, see lms3dEmbreeTree::Build. Mesh and test
  /// must outlive this object.
  lms3dEmbreeCandidates(
    const lms3dTriangleMesh& mesh, const lms3dCandidateTest& test, const lms3dProgress& progress);

  ~lms3dEmbreeCandidates();
  lms3dEmbreeCandidates(const lms3dEmbreeCandidates&) = delete;
  lms3dEmbreeCandidates& operator=(const lms3dEmbreeCandidates&) = delete;

  /// Fills Range and Triangle of some packets as the test decides. Several threads may call this at
  /// once.
  void Cast(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
