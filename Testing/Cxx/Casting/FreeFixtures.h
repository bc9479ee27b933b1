// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Packets of beams that start at points of their own, where casters are most likely to fail.
 */
#ifndef FreeFixtures_h
#define FreeFixtures_h

#include "Fixtures/VectorFixtures.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"

/// Where the beams of a packet start.
enum class Starts
{
  /// Anywhere in the box around the scene.
  Inside,
  /// On faces, edges and vertices.
  OnTriangles,
  /// Within a thousandth of the diagonal of the scene.
  Footprint,
  /// Some in the scene, some beside it, some up to 1e7 diagonals away.
  Mixed
};

/// Where the beams of a packet lead.
enum class Aims
{
  /// Some to vertices, edges and points of faces, some in any direction, some along axes.
  Everywhere,
  /// To points of faces, not near to an edge.
  Faces
};

/// Sets Origin and Direction of all beams.
void FillFreePacket(
  const lms3dTriangleMesh& mesh, Starts starts, Aims aims, Random& random, lms3dFreePacket& packet);

/// Returns a packet with one active beam of a packet, as beams with one origin have it.
lms3dBeamPacket MakeLonelyPacket(const lms3dFreePacket& packet, int beam);

lms3dRayOrigin GetRayOrigin(const lms3dFreePacket& packet, int beam, double maximumRange);

#endif
