// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteFusedMapCheck.h"

#include "Common/lms3dChecksum.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace
{
static_assert(sizeof(LMS3D::FusedRegion) == 3 * sizeof(CORBA::ULong), "regions have no gaps");

void Require(bool isValid, const LMS3D::FusedMapHeader& header, const char* reason)
{
  if (!isValid)
  {
    throw std::runtime_error("state " + std::to_string(header.number) +
      " of the server's fused map is invalid: " + reason);
  }
}

template <typename Element>
std::uint32_t Continue(std::uint32_t checksum, const std::vector<Element>& elements)
{
  return lms3dContinueChecksum(checksum, elements.data(), elements.size() * sizeof(Element));
}

// Each region has the points that its triangles refer to.
bool HaveRegionsTheirPoints(const lms3dFusedMapChanges& changes)
{
  auto corner = changes.Triangles.begin();
  for (const LMS3D::FusedRegion& region : changes.Regions)
  {
    const auto end = corner + 3 * static_cast<std::ptrdiff_t>(region.triangles);
    if (!std::all_of(corner, end, [&region](std::uint32_t index) { return index < region.points; }))
    {
      return false;
    }
    corner = end;
  }
  return true;
}
} // namespace

void lms3dCheckFusedMapHeader(const LMS3D::FusedMapHeader& header, CORBA::ULongLong since)
{
  Require(header.since == since && (header.isWhole || header.number >= since) &&
      header.number >= header.firstNumber,
    header, "it is older than the state of the client");
  Require(header.regions <= lms3dMaximumFusedPoints && header.points <= lms3dMaximumFusedPoints &&
      header.triangles <= 2 * lms3dMaximumFusedPoints &&
      header.allTriangles <= 2 * lms3dMaximumFusedPoints,
    header, "it is too large");
  Require(std::isfinite(header.origin.x) && std::isfinite(header.origin.y) &&
      std::isfinite(header.origin.z),
    header, "its origin is not finite");
}

void lms3dCheckFusedMapChanges(const lms3dFusedMapChanges& changes)
{
  const LMS3D::FusedMapHeader& header = changes.Header;
  Require(changes.Regions.size() == header.regions &&
      changes.Points.size() == 3 * std::size_t(header.points) &&
      changes.Triangles.size() == 3 * std::size_t(header.triangles),
    header, "its header has other numbers of elements");
  const std::uint32_t checksum = Continue(0, changes.Regions);
  Require(Continue(Continue(checksum, changes.Points), changes.Triangles) == header.checksum,
    header, "its changes do not match their checksum");
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  for (const LMS3D::FusedRegion& region : changes.Regions)
  {
    points += region.points;
    triangles += region.triangles;
  }
  Require(points == header.points && triangles == header.triangles, header,
    "its regions have other numbers of elements together");
  const auto notIncreasing = std::adjacent_find(changes.Regions.begin(), changes.Regions.end(),
    [](const LMS3D::FusedRegion& a, const LMS3D::FusedRegion& b) { return a.id >= b.id; });
  Require(notIncreasing == changes.Regions.end(), header, "the ids of its regions do not increase");
  Require(std::all_of(changes.Points.begin(), changes.Points.end(),
            [](float value) { return std::isfinite(value); }),
    header, "some of its points are not finite");
  Require(HaveRegionsTheirPoints(changes), header,
    "some of its triangles refer to points that do not exist");
}
