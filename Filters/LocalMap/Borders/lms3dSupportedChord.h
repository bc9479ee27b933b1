// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far a return supports the plane of its patch into the gate of a depth step.
 */
#ifndef lms3dSupportedChord_h
#define lms3dSupportedChord_h

/// The chord of a gate, from the direction of a return (0) to the direction beyond (1), both of
/// length 1. Positions are shares of the chord. The inverse ranges of a plane are linear along it.
struct lms3dSupportedChord
{
  /**
   * The end of the supported part that begins at the return: `maximum` if the plane is supported
   * there, otherwise a position within 1/256 of `maximum` before the end. Finds it by bisection,
   * two steps at a time: what the second step needs is known for either outcome of the first, so
   * that the processor need not wait for it.
   */
  double FindEnd(double maximum) const;

  /// Whether the range of the plane lies in lms3dRangeSupport::GetInterval().
  bool IsSupported(double at) const;

  /// The inverse range of the plane at 0, 1/metre, and its change from 0 to 1.
  double Inverse;
  double Change;
  /// The cosine of the angle between the directions.
  double Cosine;
  /// The range of the return and its margin, metres, as lms3dRangeSupport::GetInterval() has them.
  double Range;
  double Margin;
};

#endif
