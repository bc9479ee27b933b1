// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dChecksum.h"

#include <zlib.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "The checksums are of little-endian numbers: swap bytes here on a big-endian machine"
#endif

namespace
{
template <typename Number>
std::uint32_t Continue(std::uint32_t checksum, const std::vector<Number>& numbers)
{
  return lms3dContinueChecksum(checksum, numbers.data(), numbers.size() * sizeof(Number));
}
} // namespace

std::uint32_t lms3dGetRangesChecksum(const std::vector<float>& ranges)
{
  return Continue(0, ranges);
}

std::uint32_t lms3dGetMapChecksum(
  const std::vector<double>& points, const std::vector<std::uint32_t>& triangles)
{
  return Continue(Continue(0, points), triangles);
}

std::uint32_t lms3dContinueChecksum(
  std::uint32_t checksum, const void* data, std::size_t numberOfBytes)
{
  // zlib takes a null pointer, which an empty vector has, for a new checksum.
  return numberOfBytes == 0
    ? checksum
    : static_cast<std::uint32_t>(crc32_z(checksum, static_cast<const Bytef*>(data), numberOfBytes));
}
