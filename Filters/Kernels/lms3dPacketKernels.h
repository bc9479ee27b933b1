// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The arithmetic that is done for all beams of a packet, or of a strip of a map, at once.
 *
 * It is compiled for several instruction sets; the widest one of the processor is chosen at run
 * time. All results have the same bits: the sets do the same operations in the same order, and the
 * compiler may not contract a product and a sum. There are two exceptions:
 * - Below 1e-290 m, thus in scenes smaller than 1e-90 m, the last bits of a range may differ,
 *   because products underflow.
 * - The kernels that decide on narrow triangles and on tiles use fused multiply-add where the set
 *   has it. Their inverse ranges differ within the error bounds, and a set may be sure of a beam
 *   where another is not. The exact arithmetic then decides, so no result of a scan differs.
 *
 * Lengths are in metres. "Sensor frame" means coordinates relative to the sensor's position, with
 * the axes of the world. A set of beams is a mask: bit i stands for beam i of the packet.
 */
#ifndef lms3dPacketKernels_h
#define lms3dPacketKernels_h

#include "Geometry/lms3dTwoSum.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dFreeKernels.h"
#include "Kernels/lms3dNarrowTriangle.h"
#include "Kernels/lms3dNormalStrip.h"
#include "Kernels/lms3dPacketPlanes.h"
#include "Kernels/lms3dRangeErrorRow.h"
#include "Kernels/lms3dReturnArrays.h"
#include "Kernels/lms3dTile.h"
#include "Kernels/lms3dTileBeams.h"

#include <cstddef>
#include <cstdint>

/// Cosine and sine of the elevation of each beam of a packet.
struct lms3dElevations
{
  alignas(64) double Cosine[lms3dBeamPacket::Size];
  alignas(64) double Sine[lms3dBeamPacket::Size];
};

/// The fan's horizontal axis for each beam of a packet, and the upward axis for all; unit vectors
/// in world coordinates.
struct lms3dFanAxes
{
  alignas(64) double Horizontal[3][lms3dBeamPacket::Size];
  double Up[3];
};

/// The corners of a triangle in the sensor frame, each coordinate rounded once.
struct lms3dSensorFrameTriangle
{
  double Corner[3][3];
};

/// Which beams pass inside a triangle. Beams in neither mask pass outside.
struct lms3dHitMasks
{
  /// Beams that certainly pass inside.
  std::uint32_t Hit;

  /// Beams so near to an edge that double precision cannot decide.
  std::uint32_t Uncertain;
};

/// The directions d with Axis.d >= Minimum.
struct lms3dCone
{
  double Axis[3];
  double Minimum;
};

/// One coordinate of where rays start: `RayOffset` along each beam from `Origin` (world
/// coordinates). The result is relative to `Center`, in units of `Unit` metres. Beams whose result
/// exceeds `MaximumDistance` units are not cast.
struct lms3dShiftedOrigin
{
  double Origin;
  double RayOffset;
  double Center;
  double Unit;
  double MaximumDistance;
};

/// The rays of beams First to First + Count - 1 as Embree holds them. The arrays belong to Embree
/// or the caller.
struct lms3dRayRange
{
  int First;
  int Count;

  /// Where the rays end, in units of the normalized scene from the rays' start.
  float* TFar;

  /// The geometry that each ray hit.
  unsigned int* Geometry;
};

struct lms3dPacketKernels
{
  const char* Name;

  /// How many rays of a packet Embree casts at once with the same instruction set.
  int RaysAtOnce;

  /// Fills Direction and NarrowDirection of a packet.
  void (*GenerateDirections)(
    const lms3dElevations& elevations, const lms3dFanAxes& axes, lms3dBeamPacket& packet);

  /// Returns the beams whose direction lies in a cone.
  std::uint32_t (*FindInCone)(const lms3dCone& cone, const lms3dBeamPacket& packet);

  /// Computes one coordinate of the origin of each ray, 0 for those beyond the maximum distance.
  /// Returns the beams within that distance.
  std::uint32_t (*ShiftOrigins)(
    const lms3dShiftedOrigin& origin, const double* directions, float* origins);

  /// Finds the beams among `beams` that pass inside a triangle, by the signs of its three edge
  /// functions with a bound of their rounding errors.
  lms3dHitMasks (*Classify)(
    const lms3dSensorFrameTriangle& triangle, std::uint32_t beams, const lms3dBeamPacket& packet);

  /**
   * Stores the hits of the beams in `hits` that are nearer than the packet's present ones and not
   * beyond a maximum range. Of two triangles at the same range the one with the smaller index wins.
   * Ranges have about 13 digits. Beams whose range would have fewer digits stay as they were and
   * are added to `uncertain`. Returns the beams that changed.
   */
  std::uint32_t (*UpdateNearest)(const lms3dSensorFrameTriangle& corners, std::int32_t triangle,
    std::uint32_t hits, double maximumRange, lms3dBeamPacket& packet, std::uint32_t& uncertain);

  /// Computes what single precision needs of a triangle. `unit`, metres, is the range whose inverse
  /// is 1.
  lms3dNarrowTriangle (*MakeNarrowTriangle)(const lms3dSensorFrameTriangle& triangle, double unit);

  /// Stores the hits of some beams that are certainly nearer than the present ones, in `hits` and
  /// in the packet's Triangle. PlaneError must not be negative. Does not use the packet's Range.
  lms3dNarrowMasks (*UpdateNarrow)(const lms3dNarrowTriangle& triangle, std::int32_t number,
    std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits);

  /// The same for a triangle without its narrow form, which is computed as far as the beams need
  /// it.
  lms3dNarrowMasks (*UpdateFromCorners)(const lms3dCornerPoints& points, std::int32_t number,
    std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits);

  /// Sets the hits of changed beams to the packet's Range. `unit` is that of MakeNarrowTriangle.
  void (*NarrowRanges)(
    const lms3dBeamPacket& packet, std::uint32_t changed, double unit, lms3dNarrowHits& hits);

  /// Ends the rays of changed beams a little beyond their hits, and sets their geometry.
  /// `rayOffset` is in the units of the hits.
  void (*ClipRays)(const lms3dNarrowHits& hits, std::uint32_t changed, float rayOffset,
    unsigned int geometry, const lms3dRayRange& rays);

  /// Fills the corners and sides of sixteen tiles.
  void (*FillTileCorners)(lms3dTiles& tiles);

  /**
   * Decides what a triangle does to tiles, and updates their cover. On input, Met has the tiles to
   * test; Covered equals Met if the triangle is known to cover them, otherwise 0; Nearest is 0.
   * `minimumInverse` is the inverse of the maximum range, rounded up.
   */
  void (*ClassifyTiles)(const lms3dTiles& tiles, const lms3dNarrowTriangle& triangle,
    const lms3dCornerDirections& corners, float minimumInverse, lms3dTileMasks& masks,
    lms3dTileCover& cover);

  /// Returns the tiles that may meet a box.
  std::uint32_t (*FindTilesOfBox)(const lms3dTiles& tiles, const lms3dTileBox& box);

  /// Returns the beams that have hit a triangle.
  std::uint32_t (*FindHits)(const lms3dBeamPacket& packet);

  /// Computes the plane of three corners in world coordinates, relative to `origin`.
  lms3dDoubleDoublePlane (*MakeDoubleDoublePlane)(
    const double* const* corners, const double* origin);

  /// Does so for the first `count` triangles, a multiple of lms3dPacketPlanes::Step.
  void (*MakeDoubleDoublePlanes)(
    const lms3dPacketCorners& corners, int count, const double* origin, lms3dPacketPlanes& planes);

  /// Computes the plane of a triangle in the sensor frame.
  lms3dDoublePlane (*MakeDoublePlane)(const lms3dSensorFrameTriangle& triangle);

  /// Computes Offset / Normal.direction for all beams, within 2 units in the last place if the
  /// triangle has an area.
  void (*IntersectDoubleDoublePlane)(
    const lms3dDoubleDoublePlane& plane, const lms3dBeamPacket& packet, double* ranges);

  /// The same for the beams of a tile, `stride` ranges from one turn to the next. Returns whether
  /// all ranges are above 0 and in an interval. No beam may be nearly parallel to the plane: the
  /// product Normal.direction must exceed its rounding errors, 1e-15 times the normal's 1-norm.
  bool (*IntersectTile)(const lms3dDoubleDoublePlane& plane, const lms3dBeamsOfTile& beams,
    const lms3dRangeWindow& within, double* ranges, std::ptrdiff_t stride);

  /// The same for beams that each have a plane of their own.
  void (*IntersectDoubleDoublePlanes)(
    const lms3dPacketPlanes& planes, const lms3dBeamPacket& packet, double* ranges);

  /// The same with the rounding of double precision.
  void (*IntersectDoublePlane)(
    const lms3dDoublePlane& plane, const lms3dBeamPacket& packet, double* ranges);

  /// Stores the range of the beams whose Triangle is `triangle`, and returns these beams. A hit is
  /// removed if its range is 0 or less, or above the maximum.
  std::uint32_t (*StoreRanges)(
    const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet);

  /// Does what IntersectDoubleDoublePlane and StoreRanges do.
  std::uint32_t (*RefineRanges)(const lms3dDoubleDoublePlane& plane, std::int32_t triangle,
    double maximumRange, lms3dBeamPacket& packet);

  /// Stores the range of some beams likewise.
  void (*StoreRangesOfBeams)(
    const double* ranges, std::uint32_t beams, double maximumRange, lms3dBeamPacket& packet);

  /// Removes hits that are nearer than a minimum, and makes the range of beams without a hit NaN.
  void (*ApplyMinimumRange)(double minimumRange, lms3dBeamPacket& packet);

  /// Computes the world coordinates of the returns, three numbers for each.
  void (*Locate)(const lms3dReturnsOfTurn& returns, double* points);

  /// Adds the normals of the triangles between the strip's two turns, completes the sums of the
  /// first turn and makes the second turn the first one.
  void (*AddStrip)(lms3dNormalStrip& strip);

  /// Fills 2 * `pairs` independent normal deviates (mean 0, variance 1), one for each beam of the
  /// turn.
  void (*DrawNormals)(const lms3dDrawKey& key, int pairs, double* deviates);

  /// Replaces ranges (metres) by the reported ones: NaN where a range is NaN, or would not be above
  /// 0 and finite.
  void (*ReportRanges)(
    const lms3dRangeErrorModel& model, const double* deviates, int count, double* ranges);

  lms3dReturnKernels Returns;
  lms3dFreeKernels Free;
};

/// Returns the kernels of the processor's widest instruction set, or of a narrower one that the
/// environment variable LMS3D_KERNELS names: Baseline, AVX2 or AVX512. Embree is restricted alike
/// (lms3dGetEmbreeConfiguration).
const lms3dPacketKernels& lms3dGetPacketKernels();

///@{
/// All kernels that this build has and the processor can run, from the narrowest to the widest; for
/// tests.
int lms3dGetNumberOfPacketKernels();
const lms3dPacketKernels& lms3dGetPacketKernels(int i);
///@}

#endif
