// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans that decide whole tiles, compared with packets that Embree casts.
 */
#ifndef TileScans_h
#define TileScans_h

#include "Fixtures/VectorFixtures.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <vector>

/// Scans a mesh with Exact from each sensor, upright and turned, with several grids and maximum
/// ranges, and expects the bits of packets that no tile has. Returns how many scans decided whole
/// tiles. The number is the same for all instruction sets.
int ExpectEqualScans(const lms3dTriangleMesh& mesh, const std::vector<Vector>& sensors,
  const std::vector<double>& maximumRanges);

/// The same for one scan of the whole sphere with an upright sensor.
bool ExpectEqualScan(const lms3dTriangleMesh& mesh, const Vector& sensor, double maximumRange);

#endif
