// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The exact test of triangles against beams that start at points of their own.
 *
 * Each beam gets the triangle and the range that lms3dExactView gives for the beam's start. All
 * beams are tested in double precision; exact arithmetic decides where its error bounds do not.
 */
#ifndef lms3dExactFreeTest_h
#define lms3dExactFreeTest_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

/// The methods are const, so that several threads can test different packets at once.
class lms3dExactFreeTest
{
public:
  /// The mesh must outlive this object.
  lms3dExactFreeTest(const lms3dTriangleMesh& mesh, double maximumRange);

  /// Tests one triangle for some active beams. Returns the beams that have their nearest hit there
  /// now. The packet's Range is that of its Triangle, with about 13 digits.
  std::uint32_t Test(std::uint32_t triangle, std::uint32_t beams, lms3dFreePacket& packet) const;

private:
  std::uint32_t TestUncertain(
    std::int32_t triangle, const lms3dFreeMasks& masks, lms3dFreePacket& packet) const;

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const double MaximumRange;
};

#endif
