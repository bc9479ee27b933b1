// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of one turn, and where their values go.
 */
#ifndef lms3dReturnArrays_h
#define lms3dReturnArrays_h

#include <cstdint>

/// The returns of one turn, and where their beams start. The arrays belong to the caller.
struct lms3dReturnsOfTurn
{
  /// Cosine and sine of the elevation, and range, of each return.
  const double* Cosines;
  const double* Sines;
  const double* Ranges;
  int Count;

  /// The fan's horizontal axis, the upward axis and the sensor's position in world coordinates.
  const double* FanAxis;
  const double* Up;
  const double* Position;
};

/// The returns of neighbouring beams of one turn. All arrays belong to the caller. Apart from
/// Range, which may be Ranges, no output overlaps another array.
struct lms3dReturnRunArrays
{
  int Count;

  ///@{
  /// One value for each beam of the run: range, metres, and elevation, degrees.
  const double* Ranges;
  const double* Elevations;
  ///@}

  /// The platform's angle, degrees.
  float Angle;

  /// The numbers of the first beam and of the first return in the scan.
  std::int32_t FirstBeam;
  std::int32_t FirstSlot;

  ///@{
  /// The outputs, one value for each return.
  double* Range;
  float* Alpha;
  float* Beta;
  std::int32_t* BeamId;
  std::int32_t* Offset;
  std::int32_t* Point;
  ///@}
};

/// The kernels for many returns; `triangles` has one value for each beam.
struct lms3dReturnKernels
{
  /// Fills the arrays of a run of returns.
  void (*FillRun)(const lms3dReturnRunArrays& run);

  /// Copies the numbers of triangles.
  void (*WidenTriangles)(const std::int32_t* triangles, int count, long long* cells);

  /// Returns how many beams have a triangle.
  int (*CountReturns)(const std::int32_t* triangles, int count);
};

#endif
