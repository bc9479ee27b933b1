// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The plain grid as an output of vtkLMS3DSurfaceReconstructionFilter.
 */
#ifndef lms3dGridMap_h
#define lms3dGridMap_h

#include "LocalMap/Grid/lms3dGridMesher.h"
#include "Pipeline/lms3dMemoryPool.h"
#include "Pipeline/lms3dProgress.h"

class lms3dScanInput;
class vtkPolyData;

/// Makes one map after the other, in memory that is used again. To be called in the TBB arena whose
/// threads it is to use.
class lms3dGridMap
{
public:
  /// Every vertex of the grid with `Range` and normal, and its triangles; nothing where `progress`
  /// stopped it.
  void Fill(const lms3dScanInput& scan, const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
    const lms3dProgress& progress, vtkPolyData* map);

private:
  lms3dMemoryPool Pool;
  lms3dGridPoints Points;
  lms3dGridMesher Mesher;
};

#endif
