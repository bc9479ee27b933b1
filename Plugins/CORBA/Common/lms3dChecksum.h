// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The checksums that LMS3DScanner.idl defines.
 */
#ifndef lms3dChecksum_h
#define lms3dChecksum_h

#include <cstddef>
#include <cstdint>
#include <vector>

///@{
/// CRC-32, as zlib computes it, of the numbers as little-endian bytes: of the ranges, or of the
/// points followed by the triangles.
std::uint32_t lms3dGetRangesChecksum(const std::vector<float>& ranges);
std::uint32_t lms3dGetMapChecksum(
  const std::vector<double>& points, const std::vector<std::uint32_t>& triangles);
///@}

/// Continues such a checksum, at first 0, with little-endian bytes.
std::uint32_t lms3dContinueChecksum(
  std::uint32_t checksum, const void* data, std::size_t numberOfBytes);

#endif
