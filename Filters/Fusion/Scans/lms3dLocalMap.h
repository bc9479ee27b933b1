// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A local map with the triangle of each return.
 */
#ifndef lms3dLocalMap_h
#define lms3dLocalMap_h

#include "Device/lms3dScanInput.h"
#include "Fusion/Scans/lms3dSeenRanges.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Pipeline/lms3dProgress.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

/// A return that the local map explains. World coordinates, metres.
struct lms3dMappedReturn
{
  lms3dVector Point;
  /// The beam's, with length 1.
  lms3dVector Direction;
  double Range;
  std::int32_t BeamId;
  std::int32_t Triangle;
  /// The number of the scan in the fused map, -1 for the scan that joins it.
  std::int32_t Scan = -1;
};

struct lms3dLocalMap
{
  /// Casts the beams of the scan at its map, with the threads of the calling TBB arena. If a beam
  /// misses, a triangle behind another one, or the nearest corner, can explain its return. Scan and
  /// map must be valid, and the map must have triangles. The returns take the place of others,
  /// since new memory for them would cost as much time as the returns themselves.
  lms3dLocalMap(vtkPolyData* map, const lms3dScanInput& scan, const lms3dSeenRanges& ranges,
    double maximumError, std::vector<lms3dMappedReturn> others = {});

  /// A corner of a triangle.
  lms3dVector GetCorner(int triangle, int corner) const
  {
    const double* point = this->Mesh.GetCorner(triangle, corner);
    return { point[0], point[1], point[2] };
  }

  /// Copies of some returns.
  std::vector<lms3dMappedReturn> Select(const std::vector<int>& numbers) const;

  lms3dTriangleMesh Mesh;
  /// The patch of each triangle, -1 for triangles between patches.
  std::vector<int> PatchIds;
  int NumberOfPatches = 0;
  std::vector<lms3dMappedReturn> Returns;
};

#endif
