// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Intersects beams with the planes of their triangles, with about 31 digits.
 */
#ifndef lms3dDoubleDoubleIntersector_h
#define lms3dDoubleDoubleIntersector_h

#include "Casting/lms3dPlaneCache.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstddef>
#include <cstdint>

/// Keeps the planes of recent triangles. The mesh must outlive this object.
class lms3dDoubleDoubleIntersector
{
public:
  explicit lms3dDoubleDoubleIntersector(const lms3dTriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Keeps the planes if the origin is the one of the last call.
  void SetOrigin(const double origin[3]);

  /// Sets Range of all beams of a packet that have a Triangle. Removes a hit if the range is 0 or
  /// less, or above the maximum.
  void Refine(double maximumRange, lms3dBeamPacket& packet);

  /// Does what lms3dRangeRefinement::FillTile does.
  bool FillTile(std::int32_t triangle, const lms3dBeamsOfTile& beams,
    const lms3dRangeWindow& within, double* ranges, std::ptrdiff_t stride);

private:
  /// Enough for a whole scan of a small scene.
  static constexpr int NumberOfPlanes = 1024;

  struct Plane
  {
    lms3dDoubleDoublePlane Value;
    bool IsNear;
  };

  struct MissingPlanes;

  std::uint32_t RefineFirst(std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet);
  bool RefineEach(std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet);
  void MakePlanes(MissingPlanes& missing) const;
  Plane MakePlane(std::int32_t triangle) const;
  const Plane& GetPlane(std::int32_t triangle)
  {
    return this->Planes.Get(triangle, [this](std::int32_t t) { return this->MakePlane(t); });
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  lms3dPlaneCache<Plane, NumberOfPlanes> Planes;
};

#endif
