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

#include <vtkSmartPointer.h>

class lms3dMapScan;
class vtkCellArray;
class vtkPolyData;

/// Fills maps in which every return is a vertex. Reuses the memory of earlier maps. Uses the
/// threads of the calling TBB arena.
class lms3dGridMap
{
public:
  /**
   * Fills an empty map with points in world coordinates, `Range` and normals, and with the
   * triangles that the joins allow. If `progress` returns false, the map stays empty. `grid` and
   * `joins` must be made of the scan. Throws std::runtime_error, with a message for the user, if
   * there are too many triangles for 32-bit cells.
   */
  void Fill(const lms3dMapScan& scan, const lms3dRangeGrid& grid, const lms3dRangeJoins& joins,
    const lms3dProgress& progress, vtkPolyData* map);

private:
  vtkSmartPointer<vtkCellArray> MakeTriangles(const lms3dRangeGrid& grid);

  lms3dMemoryPool Pool;
  lms3dGridPoints Points;
  lms3dGridMesher Mesher;
};

#endif
