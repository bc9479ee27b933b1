// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteCheck.h"

#include "Common/lms3dChecksum.h"
#include "Common/lms3dDeviceLimits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace
{
constexpr std::uint64_t MaximumBeams = 4000000;
constexpr std::uint64_t MaximumMapPoints = 16000000;

void Require(bool isValid, const LMS3D::ScanHeader& header, const char* reason)
{
  if (!isValid)
  {
    throw std::runtime_error(
      "scan " + std::to_string(header.number) + " of the server is invalid: " + reason);
  }
}

bool IsFinite(const LMS3D::Vector3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool IsValid(const LMS3D::Axis& axis)
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
  Require(IsValid(alpha) && IsValid(beta), header, "its angles are not finite or do not increase");
  Require(beams == header.beams && beams <= MaximumBeams, header,
    "its number of beams does not match its grid or exceeds 4,000,000");
  Require(header.returns <= header.beams, header, "it has more returns than beams");
  Require(IsFinite(header.sensorPose.position) && IsFinite(header.sensorPose.orientation), header,
    "its pose is not finite");
  Require(header.mapPoints <= MaximumMapPoints && header.mapTriangles <= 2 * MaximumMapPoints,
    header, "its map is too large");
}

void lms3dCheckDevice(const lms3dRemoteScan& scan)
{
  const LMS3D::Vector3& offset = scan.Device.axisOffset;
  const auto isWithin = [](double value, double limit) { return std::abs(value) <= limit; };
  Require(isWithin(offset.x, lms3dMaximumLength) && isWithin(offset.y, lms3dMaximumLength) &&
      isWithin(offset.z, lms3dMaximumLength),
    scan.Header, "the offset of its device is too large");
  Require(isWithin(scan.Device.turnRate, lms3dMaximumTurnRate), scan.Header,
    "the turn rate of its device is too large");
}

void lms3dCheckArrays(const lms3dRemoteScan& scan)
{
  const LMS3D::ScanHeader& header = scan.Header;
  Require(lms3dGetRangesChecksum(scan.Ranges) == header.rangesChecksum, header,
    "its ranges do not match their checksum");
  Require(lms3dGetMapChecksum(scan.MapPoints, scan.MapTriangles) == header.mapChecksum, header,
    "its map does not match its checksum");

  const std::vector<float>& ranges = scan.Ranges;
  const auto returns =
    std::count_if(ranges.begin(), ranges.end(), [](float range) { return range > 0.0F; });
  const auto misses = std::count(ranges.begin(), ranges.end(), 0.0F);
  Require(AreFinite(ranges) && static_cast<std::size_t>(returns + misses) == ranges.size(), header,
    "some ranges are negative or not finite");
  Require(static_cast<std::uint64_t>(returns) == header.returns, header,
    "its header has another number of returns than its ranges");

  const std::vector<std::uint32_t>& corners = scan.MapTriangles;
  Require(AreFinite(scan.MapPoints), header, "some points of its map are not finite");
  Require(std::all_of(corners.begin(), corners.end(),
            [&header](std::uint32_t corner) { return corner < header.mapPoints; }),
    header, "some triangles of its map refer to points that do not exist");
}
