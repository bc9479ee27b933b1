// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A mesh seen from one origin, and the test of its triangles against packets of beams.
 *
 * Each beam gets the nearest triangle that it hits within the maximum range; of equally near ones,
 * the one with the smallest index. Single precision decides wherever its error bounds allow. Double
 * precision with an error bound decides on most other beams. Exact arithmetic decides on the rest.
 * All three find the same triangles, so the results do not depend on the order of the tests.
 */
#ifndef lms3dExactView_h
#define lms3dExactView_h

#include "Casting/lms3dPlaneCache.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>
#include <cstdint>
#include <memory>

/// The narrow triangles that one thread used last, 256 KiB: neighbouring packets meet the same
/// ones.
using lms3dNarrowCache = lms3dPlaneCache<lms3dNarrowTriangle, 4096>;

/// A packet while its nearest hits are searched. The packet's Triangle is always up to date.
struct lms3dPacketSearch
{
  /// The range of each beam's triangle in single precision.
  lms3dNarrowHits Hits;

  lms3dBeamPacket* Packet;

  /// The beams whose Range in the packet is that of their triangle, with about 13 digits.
  std::uint32_t HaveRange;

  /// Null, or where narrow triangles are kept.
  lms3dNarrowCache* Kept = nullptr;
};

/// The methods are const, so that several threads can test different packets at once.
class lms3dExactView
{
public:
  /// `unit` is a length of the size of the scene, metres. The mesh must outlive this object.
  lms3dExactView(const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin, double unit);

  /// Computes what single precision needs, 64 bytes for each triangle, with the threads of the
  /// calling TBB arena. Without this call, they are computed for each test, or kept by
  /// KeepNarrowTriangles.
  void MakeNarrowTriangles();

  ///@{
  /// The same in steps: memory for all triangles, then the triangles from `begin` up to, but not
  /// including, `end`. Several threads can compute different triangles at the same time.
  void AllocateNarrowTriangles();
  void MakeNarrowTriangles(std::size_t begin, std::size_t end);
  ///@}

  /// Keeps the narrow triangles that each thread used last. Pays for many packets.
  void KeepNarrowTriangles() { this->Kept = std::make_unique<NarrowCaches>(); }

  /// Returns the calling thread's cache for lms3dPacketSearch, or null.
  lms3dNarrowCache* GetKept() const { return this->Kept ? &this->Kept->local() : nullptr; }

  /// Begins the search of a packet whose directions are set.
  void Begin(lms3dBeamPacket& packet, lms3dPacketSearch& search) const;

  /// Tests one triangle for some active beams. Returns the beams that have their nearest hit there
  /// now.
  std::uint32_t Test(std::uint32_t triangle, std::uint32_t beams, lms3dPacketSearch& search) const;

  /// Sets Range of all beams that have a triangle to the range by which triangles are compared,
  /// metres, with about 13 digits; NoRange for beams without one.
  void ComputeRanges(lms3dBeamPacket& packet) const;

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }
  const lms3dRayOrigin& GetOrigin() const { return this->Origin; }

  /// The inverse of the maximum range in units, rounded up.
  float GetMinimumInverse() const { return this->MinimumInverse; }

  /// Returns a narrow triangle, which stays valid until the next call. `kept` is GetKept, and may
  /// be null only after MakeNarrowTriangles.
  const lms3dNarrowTriangle& GetNarrowTriangle(std::int32_t triangle, lms3dNarrowCache* kept) const
  {
    return this->NarrowTriangles
      ? this->NarrowTriangles[triangle]
      : kept->Get(triangle, [this](std::int32_t t) { return this->MakeNarrowTriangle(t); });
  }

private:
  using NarrowCaches = tbb::enumerable_thread_specific<lms3dNarrowCache>;

  lms3dNarrowTriangle MakeNarrowTriangle(std::size_t triangle) const;
  std::uint32_t TestWide(
    std::uint32_t triangle, std::uint32_t beams, lms3dPacketSearch& search) const;
  std::uint32_t Update(const lms3dCorners& corners, const lms3dSensorFrameTriangle& inSensorFrame,
    std::int32_t triangle, const lms3dHitMasks& masks, lms3dBeamPacket& packet) const;
  std::uint32_t UpdateUncertain(const lms3dCorners& corners, std::int32_t triangle,
    std::uint32_t beams, std::uint32_t needInsideTest, lms3dBeamPacket& packet) const;
  void FindRanges(std::uint32_t beams, lms3dBeamPacket& packet) const;
  void FindRanges(std::int32_t triangle, std::uint32_t beams, lms3dBeamPacket& packet) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const lms3dRayOrigin Origin;
  const double Unit;
  const float MinimumInverse;
  std::unique_ptr<lms3dNarrowTriangle[]> NarrowTriangles;
  std::unique_ptr<NarrowCaches> Kept;
};

#endif
