// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The parts of a local map that have too few returns for their size.
 */
#ifndef lms3dSparseParts_h
#define lms3dSparseParts_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dBeamTable.h"
#include "Fusion/Scans/lms3dLocalMap.h"

#include <vector>

/**
 * The raster of a surface takes time and memory by its area, and the beams of a scan that meets
 * something far away are far apart there. Therefore a part with too many blocks of the raster is
 * sparse: it has surface near its returns alone. Parts are the patches, and the triangles that
 * belong to none. A part may have a number of blocks for each of its returns, a patch 64 more. This
 * limit is 64; it is 32 or 16 if the scan could have more than 500,000 blocks otherwise, and more
 * than 16 for each of its returns. So the time and the memory of a scan are bounded by the number
 * of its returns.
 */
class lms3dSparseParts
{
public:
  /// Keeps a reference. `cell` is the size of a cell, metres.
  lms3dSparseParts(const lms3dLocalMap& local, double cell);

  /// Whether a triangle has too many blocks for its own returns.
  bool IsSparseTriangle(int triangle) const { return this->SparseTriangles[triangle]; }

  /// Replaces the plane of each sparse patch by -1.
  std::vector<int> SelectDense(std::vector<int> planeOfPatch) const;

  /// Lets the planes of sparse patches have surface between neighbouring beams that meet the patch,
  /// as far as a triangle between them has at most half of the limit. The boxes of the planes grow
  /// to all returns of the patches. `returns` has the returns of each patch.
  void Guess(const std::vector<std::vector<int>>& returns, const std::vector<int>& planeOfPatch,
    const lms3dBeamTable& table, lms3dFusedPlanes& planes) const;

private:
  const lms3dLocalMap& Local;
  /// Blocks for each return.
  double Limit = 0.0;
  std::vector<bool> SparsePatches;
  std::vector<bool> SparseTriangles;
};

#endif
