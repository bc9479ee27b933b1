// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of neighbouring beams of one turn, and where their values go.
 */
#ifndef lms3dReturnRun_h
#define lms3dReturnRun_h

#include <cstdint>

/// All arrays belong to the caller. None of the outputs overlaps another array.
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

#endif
