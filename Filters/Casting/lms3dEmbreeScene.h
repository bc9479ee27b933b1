// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene in Embree; its source is the only one that knows Embree.
 *
 * Embree works in single precision. It gets the scene moved to the origin and scaled to a diagonal
 * of 1, and the rays start near the scene, so that it culls equally well at any offset and scale.
 */
#ifndef lms3dEmbreeScene_h
#define lms3dEmbreeScene_h

#include "Casting/lms3dNormalization.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <memory>

class lms3dEmbreeScene
{
public:
  /**
   * Decides which beams of a packet hit a triangle that Embree cannot rule out, and takes their
   * ranges into the packet where they are the nearest so far. Returns the beams that changed.
   */
  class CandidateTest
  {
  public:
    virtual std::uint32_t Test(
      const lms3dViewpoint& viewpoint, std::uint32_t triangle, lms3dBeamPacket& packet) const = 0;

  protected:
    ~CandidateTest() = default;
  };

  /// Measures, one after the other, the triangles that Embree cannot rule out as the nearest.
  class NearestTest
  {
  public:
    /// Returns the distance of the nearest so far, metres.
    virtual double Test(std::uint32_t triangle) = 0;

  protected:
    ~NearestTest() = default;
  };

  /// A scene of triangles on which Embree decides itself.
  lms3dEmbreeScene(const lms3dTriangleMesh& mesh, const lms3dProgress& progress);

  /// A scene of boxes, one around each triangle; `test` decides. Both must outlive the scene.
  lms3dEmbreeScene(
    const lms3dTriangleMesh& mesh, const CandidateTest& test, const lms3dProgress& progress);

  ~lms3dEmbreeScene();
  lms3dEmbreeScene(const lms3dEmbreeScene&) = delete;
  lms3dEmbreeScene& operator=(const lms3dEmbreeScene&) = delete;

  /**
   * Fills Triangle of the packets, and Range too where a test decides; without one, Range is
   * NoRange.
   */
  void Cast(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const;

  /// Shows all triangles to the test that may be the nearest to a point, or as near as that, up to
  /// a reach in metres. The point is finite, the scene without a test for candidates.
  void FindNearest(const double point[3], double reach, NearestTest& test) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
