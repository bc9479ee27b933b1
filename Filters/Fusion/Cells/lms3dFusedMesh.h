// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles of one region of a fused map.
 */
#ifndef lms3dFusedMesh_h
#define lms3dFusedMesh_h

#include "Geometry/lms3dVector.h"

#include <array>
#include <cstdint>
#include <vector>

/// Which scans saw a place. Scans are counted from 0.
struct lms3dSightings
{
  int BestScan = -1;
  int ScanCount = 0;
  int LastScan = -1;
};

struct lms3dFusedMesh
{
  using Triangle = std::array<std::int32_t, 3>;

  /// World coordinates, metres.
  std::vector<lms3dVector> Points;
  std::vector<Triangle> Triangles;
  /// One for each triangle.
  std::vector<lms3dSightings> Sightings;

  void Clear()
  {
    this->Points.clear();
    this->Triangles.clear();
    this->Sightings.clear();
  }
};

#endif
