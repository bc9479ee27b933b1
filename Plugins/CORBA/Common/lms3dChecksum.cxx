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
uLong Continue(uLong checksum, const std::vector<Number>& numbers)
{
  return crc32_z(
    checksum, reinterpret_cast<const Bytef*>(numbers.data()), numbers.size() * sizeof(Number));
}
} // namespace

std::uint32_t lms3dGetRangesChecksum(const std::vector<float>& ranges)
{
  return static_cast<std::uint32_t>(Continue(crc32_z(0, nullptr, 0), ranges));
}

std::uint32_t lms3dGetMapChecksum(
  const std::vector<double>& points, const std::vector<std::uint32_t>& triangles)
{
  const uLong start = Continue(crc32_z(0, nullptr, 0), points);
  return static_cast<std::uint32_t>(Continue(start, triangles));
}
