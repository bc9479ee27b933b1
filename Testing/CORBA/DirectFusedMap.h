// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The map of many scans that the filters make without a server.
 */
#ifndef DirectFusedMap_h
#define DirectFusedMap_h

#include "LMS3DScanner.hh"

#include <array>
#include <string>
#include <vector>

class vtkPolyData;

/// RegionId, and the coordinates of the three corners.
using FusedTriangle = std::array<double, 10>;

/// The triangles of a map, sorted. If there is an origin, coordinates are rounded to floats
/// relative to it, as the interface sends them.
std::vector<FusedTriangle> GetFusedTriangles(
  vtkPolyData* map, const LMS3D::Vector3* origin = nullptr);

/// The map of scans from `poses` within the mapError of `configuration`. Shares no code with the
/// server.
std::vector<FusedTriangle> MakeFusedTriangles(const std::string& scene,
  const LMS3D::Configuration& configuration, const std::vector<LMS3D::Pose>& poses);

#endif
