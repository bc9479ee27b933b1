// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRemoteCheck.h"

#include "lms3dChecksum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace
{
constexpr std::uint64_t MostBeams = 4000000;
constexpr std::uint64_t MostMapPoints = 16000000;

void Require(bool isGood, const LMS3D::ScanHeader& header, const char* what)
{
  if (!isGood)
  {
    throw std::runtime_error("the server's scan " + std::to_string(header.number) + " has " + what);
  }
}

bool IsFinite(const LMS3D::Vector3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool IsProper(const LMS3D::Axis& axis)
{
  return axis.count > 0 && std::isfinite(axis.start) && std::isfinite(axis.stop) &&
    (axis.start < axis.stop || axis.count == 1);
}

template <typename T>
bool AreFinite(const std::vector<T>& values)
{
  return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
}
} // namespace

void lms3dCheckHeader(const LMS3D::ScanHeader& header)
{
  const LMS3D::Axis& alpha = header.settings.alpha;
  const LMS3D::Axis& beta = header.settings.beta;
  const std::uint64_t beams = static_cast<std::uint64_t>(alpha.count) * beta.count;
  Require(IsProper(alpha) && IsProper(beta), header, "bad angles");
  Require(beams == header.beams && beams <= MostBeams, header, "a bad number of beams");
  Require(header.returns <= header.beams, header, "more returns than beams");
  Require(IsFinite(header.sensorPose.position) && IsFinite(header.sensorPose.orientation), header,
    "a bad pose");
  Require(header.mapPoints <= MostMapPoints && header.mapTriangles <= 2 * MostMapPoints, header,
    "a map that is too large");
}

void lms3dCheckArrays(const lms3dRemoteScan& scan)
{
  const LMS3D::ScanHeader& header = scan.Header;
  Require(lms3dGetRangesChecksum(scan.Ranges) == header.rangesChecksum, header,
    "ranges that do not fit their checksum");
  Require(lms3dGetMapChecksum(scan.MapPoints, scan.MapTriangles) == header.mapChecksum, header,
    "a map that does not fit its checksum");

  const std::vector<float>& ranges = scan.Ranges;
  const auto returns =
    std::count_if(ranges.begin(), ranges.end(), [](float range) { return range > 0.0F; });
  const auto misses = std::count(ranges.begin(), ranges.end(), 0.0F);
  Require(AreFinite(ranges) && static_cast<std::size_t>(returns + misses) == ranges.size(), header,
    "ranges that are no distances");
  Require(static_cast<std::uint64_t>(returns) == header.returns, header,
    "another number of returns than it says");

  const std::vector<std::uint32_t>& corners = scan.MapTriangles;
  Require(AreFinite(scan.MapPoints), header, "a map with points that are no numbers");
  Require(std::all_of(corners.begin(), corners.end(),
            [&header](std::uint32_t corner) { return corner < header.mapPoints; }),
    header, "a map with triangles of points that it lacks");
}
