// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Changes of the map of many scans, as a client receives them.
 */
#ifndef lms3dFusedMapChanges_h
#define lms3dFusedMapChanges_h

#include "LMS3DScanner.hh"

#include <cstdint>
#include <vector>

/// LMS3DScanner.idl documents all members.
struct lms3dFusedMapChanges
{
  LMS3D::FusedMapHeader Header{};
  std::vector<LMS3D::FusedRegion> Regions;
  /// x, y, z of each point, metres, relative to Header.origin.
  std::vector<float> Points;
  /// Three indices of points for each triangle, counted in the triangle's region.
  std::vector<std::uint32_t> Triangles;
};

#endif
