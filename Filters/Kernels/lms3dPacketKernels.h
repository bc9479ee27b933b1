// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The arithmetic that is done for all beams of a packet, or of a tile of a map, at once.
 *
 * It is compiled for several instruction sets, and the widest that the processor has is chosen when
 * the program runs. Every one gives the same bits: the operations and their order are the same, and
 * no compiler may contract a product and a sum. (Beyond what a double can hold the last bits of a
 * range may differ: below 1e-290, which takes a scene smaller than 1e-90 m.)
 */
#ifndef lms3dPacketKernels_h
#define lms3dPacketKernels_h

#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dNormalTile.h"

#include <cstdint>

/// Cosine and sine of the elevation of each beam of a packet.
struct lms3dElevations
{
  alignas(64) double Cosine[lms3dBeamPacket::Size];
  alignas(64) double Sine[lms3dBeamPacket::Size];
};

/// For each beam of a packet the horizontal axis of the fan, and the upward axis of all.
struct lms3dFanAxes
{
  alignas(64) double Horizontal[3][lms3dBeamPacket::Size];
  double Up[3];
};

/// The corners of a triangle seen from the sensor.
struct lms3dSeenTriangle
{
  double Corner[3][3];
};

/// Where beams pass a triangle: bits of those that do, and of those for which double cannot tell.
struct lms3dVerdicts
{
  std::uint32_t Hit;
  std::uint32_t Doubt;
};

/// A number as the sum of two doubles.
struct lms3dDoubleDouble
{
  double High;
  double Low;
};

/// A plane, Normal.p = Offset, with p seen from the sensor.
struct lms3dSeenPlane
{
  lms3dDoubleDouble Normal[3];
  lms3dDoubleDouble Offset;
};

/// The same in plain double.
struct lms3dRoughPlane
{
  double Normal[3];
  double Offset;

  /// A beam with a smaller Normal.direction has a range of fewer than 13 digits.
  double SmallestSlope;

  /// False where the plane itself has fewer: the triangle is so narrow, or so near to the sensor's
  /// own plane.
  bool IsGood;
};

/// The beams of one turn that returned, and from where they start.
struct lms3dReturnsOfTurn
{
  /// Cosine and sine of each one's elevation, and its range.
  const double* Cosines;
  const double* Sines;
  const double* Ranges;
  int Count;

  const double* FanAxis;
  const double* Up;
  const double* Position;
};

/// The directions D with Axis.D at least Least.
struct lms3dCone
{
  double Axis[3];
  double Least;
};

/// One axis of where beams start: `HeadStart` along them from `Origin`, seen from `Center` and
/// measured in `Unit`; not farther than `Farthest` from there.
struct lms3dStart
{
  double Origin;
  double HeadStart;
  double Center;
  double Unit;
  double Farthest;
};

/// How much farther than a range Embree looks, so that what was just found does not hide what lies
/// at the same range: a share of the way from where the ray starts, and one of the range, by which
/// their difference may be rounded.
constexpr double lms3dReachMargin = 1.0 + 1e-6;
constexpr double lms3dRangeRounding = 1e-15;

/// A run of a packet's beams as Embree casts them.
struct lms3dRayRun
{
  int First;
  int Count;
  float* Reach;
  unsigned int* Geometry;
};

struct lms3dPacketKernels
{
  const char* Name;

  /// Fills both directions of a packet.
  void (*Aim)(const lms3dElevations& elevations, const lms3dFanAxes& axes, lms3dBeamPacket& packet);

  /// The beams within a cone.
  std::uint32_t (*FindWithin)(const lms3dCone& cone, const lms3dBeamPacket& packet);

  /// Sets one axis of where beams start, 0 for those that would start too far; returns the others.
  std::uint32_t (*SetStarts)(const lms3dStart& start, const double* directions, float* starts);

  /// Decides where beams pass a triangle, by the signs of its edge functions.
  lms3dVerdicts (*Classify)(const lms3dSeenTriangle& triangle, const lms3dBeamPacket& packet);

  /**
   * Takes the hits of some beams into the packet where they are the nearest so far, up to a maximum
   * range; of two triangles at the same range the one with the smaller number stays. The range has
   * about 13 digits. Beams for which double keeps fewer are left alone and told in `unsure`.
   * Returns the beams that changed.
   */
  std::uint32_t (*TakeHits)(const lms3dSeenTriangle& seen, std::int32_t triangle,
    std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet, std::uint32_t& unsure);

  /// Makes changed beams reach no farther than (Range - headStart) / unit, and a little more, and
  /// gives them a geometry.
  void (*Shorten)(const lms3dBeamPacket& packet, std::uint32_t changed, double headStart,
    double unit, unsigned int geometry, const lms3dRayRun& run);

  /// The beams with a triangle.
  std::uint32_t (*FindHits)(const lms3dBeamPacket& packet);

  /// The plane through three corners, in world coordinates, with about 31 digits.
  lms3dSeenPlane (*See)(const double* const* corners, const double* origin);

  /// The same in double, for a triangle that is seen already.
  lms3dRoughPlane (*SeeRoughly)(const lms3dSeenTriangle& seen);

  /// Offset / Normal.direction for all beams, within 2 units in the last place of a plane with
  /// area.
  void (*Measure)(const lms3dSeenPlane& plane, const lms3dBeamPacket& packet, double* ranges);

  /// The same with the rounding of double.
  void (*MeasureRoughly)(
    const lms3dRoughPlane& plane, const lms3dBeamPacket& packet, double* ranges);

  /// Sets the range of the beams that hit a triangle, and returns them; a hit is taken back where
  /// the range is not above 0, or beyond the maximum.
  std::uint32_t (*KeepRanges)(
    const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet);

  /// Makes a range NaN where there is no hit, or the hit is nearer than a minimum and taken back.
  void (*Finish)(double minimumRange, lms3dBeamPacket& packet);

  /// The coordinates of the returns, three for each.
  void (*Locate)(const lms3dReturnsOfTurn& returns, double* points);

  /// Adds the normals of the triangles between the tile's two turns, finishes the sums of the first
  /// and makes the next the first.
  void (*AddStrip)(lms3dNormalTile& tile);
};

/// Those of the widest instruction set that the processor has, unless the environment variable
/// LMS3D_KERNELS names narrower ones: Baseline, AVX2 or AVX512.
const lms3dPacketKernels& lms3dGetPacketKernels();

/// All that this build has and the processor can run, for tests.
int lms3dGetNumberOfPacketKernels();
const lms3dPacketKernels& lms3dGetPacketKernels(int i);

#endif
