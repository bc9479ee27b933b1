// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels for beams that start at points of their own.
 *
 * For each beam they do the operations of the kernels for one origin, in the same order. So a beam
 * gets the same bits in both. "Sensor frame" means coordinates relative to the start of the beam.
 */
#ifndef lms3dFreeKernels_h
#define lms3dFreeKernels_h

#include "Geometry/lms3dTwoSum.h"
#include "Kernels/lms3dBeamPacket.h"

#include <cstdint>

struct lms3dRayRange;

/// Relative to the triangle's size or distance. If a beam starts nearer to a plane, the 31 digits
/// of the plane's offset leave too few digits of the range.
constexpr double lms3dNearPlane = 1e-12;

/// The centre of a scene, and the length that normalized coordinates have as their unit, metres.
struct lms3dSceneFrame
{
  double Center[3];
  double Unit;
};

/// Where beams start, seen from the sphere around a scene: its radius is half a unit.
struct lms3dFreeStarts
{
  /// Beams that certainly start inside.
  std::uint32_t Inside;

  /// Beams that certainly start outside and pass by.
  std::uint32_t PassingBy;
};

/// What a triangle changes for the beams of a packet.
struct lms3dFreeMasks
{
  /// Beams that have their nearest hit here now.
  std::uint32_t Changed;

  /// Beams whose range needs more digits than double precision gives.
  std::uint32_t Uncertain;

  /// Beams among them that are so near to an edge that double precision cannot decide whether they
  /// hit.
  std::uint32_t NeedInsideTest;
};

/// The plane of a triangle in world coordinates, with about 31 digits.
struct lms3dFreePlane
{
  /// The cross product of two edges.
  lms3dDoubleDouble Normal[3];

  /// The corner at which both edges begin.
  double Corner[3];

  /// The 1-norms of the edges.
  double EdgeLengths[2];
};

struct lms3dFreeKernels
{
  /// Fills NarrowDirection from Direction.
  void (*NarrowDirections)(lms3dBeamPacket& packet);

  /// Computes where the rays of beams start, x, y and z in normalized coordinates, without a ray
  /// offset. The starts of beams that are neither Inside nor PassingBy may be no numbers.
  lms3dFreeStarts (*LocateStarts)(
    const lms3dSceneFrame& frame, const lms3dFreePacket& packet, float* const* starts);

  /// The same with a ray offset for each beam, metres. Starts that are farther than
  /// `maximumDistance` units along an axis become 0. Returns the other beams.
  std::uint32_t (*ShiftStarts)(const lms3dSceneFrame& frame, const double* rayOffsets,
    double maximumDistance, const lms3dFreePacket& packet, float* const* starts);

  /// Ends the rays of changed beams a little beyond the packet's Range, and sets their geometry.
  /// `unit` is in metres, `rayOffsets` are in units.
  void (*ClipRays)(const lms3dFreePacket& packet, std::uint32_t changed, double unit,
    const float* rayOffsets, unsigned int geometry, const lms3dRayRange& rays);

  /// Does what Classify and then UpdateNearest do, for the beams in `beams`. The corners are in
  /// world coordinates.
  lms3dFreeMasks (*UpdateNearest)(const double* const* corners, std::int32_t triangle,
    std::uint32_t beams, double maximumRange, lms3dFreePacket& packet);

  /// Computes the ranges of all beams in a plane, as IntersectDoubleDoublePlane does. Returns the
  /// beams that start so near to the plane that the range has too few digits.
  std::uint32_t (*IntersectPlane)(
    const lms3dFreePlane& plane, const lms3dFreePacket& packet, double* ranges);

  /// Computes the ranges of all beams in the plane of three corners, with the rounding of double
  /// precision. Returns the beams for which this plane is well conditioned.
  std::uint32_t (*IntersectDoublePlane)(
    const double* const* corners, const lms3dFreePacket& packet, double* ranges);
};

#endif
