// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The limits of a device's properties, as LMS3DScanner.idl documents them.
 */
#ifndef lms3dDeviceLimits_h
#define lms3dDeviceLimits_h

#include <cstddef>
#include <cstdint>

/// Metres, of every length and coordinate.
constexpr double lms3dMaximumLength = 1e6;

/// Metres of diameter for each metre of range.
constexpr double lms3dMaximumDivergence = 1.0;

/// Rays of a beam.
constexpr std::uint32_t lms3dMaximumSamples = 1000;

/// Rays of all beams of a scan.
constexpr std::uint64_t lms3dMaximumRays = 200000000;

/// Degrees per second.
constexpr double lms3dMaximumTurnRate = 1e6;

/// Bytes of the name of an array.
constexpr std::size_t lms3dMaximumArrayName = 128;

#endif
