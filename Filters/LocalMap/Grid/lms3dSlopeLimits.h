// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The slopes between two returns that show one surface or a depth step (lms3dDepthStep).
 */
#ifndef lms3dSlopeLimits_h
#define lms3dSlopeLimits_h

/**
 * A slope is the tangent of incidence of the line through both returns. The limits come from scans
 * of a furnished room, a castle and hills, whose true depth steps are known: of the pairs that a
 * limit joins or separates, nearly all are right. A scan is fine if neighbours are at most 1.15
 * degrees apart.
 */
namespace lms3dSlopeLimits
{
///@{
/// The steepest slopes that two returns alone can show in a fine scan. Steeper ones are depth
/// steps.
constexpr double SteepestToPlane = 18.0;
constexpr double SteepestFromPlane = 12.0;
constexpr double SteepestSmallCorner = 12.0;
constexpr double SteepestCorner = 8.0;
constexpr double SteepestSmallEdge = 8.0;
constexpr double SteepestEdge = 5.0;
///@}

///@{
/// Slopes at least this gentle in a fine scan show one surface: between planes that overlap, and
/// from a plane to a return that it meets.
constexpr double GentleOverlap = 2.0;
constexpr double GentleToPlane = 3.0;
///@}

/// The same along a fan if the nearer side is curved, and if the planes overlap or intersect.
constexpr double GentleInFan = 2.5;

///@{
/// The same in any direction if planes overlap or both sides are curved, and between beams at most
/// WidestGentle apart, radians.
constexpr double GentleCurve = 0.5;
/// The same where planes do not intersect, if the surface is whole around the returns.
constexpr double GentleWhole = 1.0;
constexpr double WidestGentle = 0.036;
///@}
} // namespace lms3dSlopeLimits

#endif
