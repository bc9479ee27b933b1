// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Writes regions of a fused map into a vtkPolyData.
 */
#ifndef lms3dFusionOutput_h
#define lms3dFusionOutput_h

#include "Fusion/Cells/lms3dFusedMesh.h"

#include <vector>

class vtkPolyData;

/// A region with its number, and the revision in which it was last changed.
struct lms3dNumberedMesh
{
  const lms3dFusedMesh* Mesh;
  int RegionId;
  int Revision;
};

/// Fills the points, triangles and cell data that the header of vtkLMS3DMapFusion documents.
void lms3dFillFusionOutput(const std::vector<lms3dNumberedMesh>& regions, vtkPolyData* output);

/// Adds int32 field data.
void lms3dAddFusionField(const char* name, const std::vector<int>& values, vtkPolyData* output);

/// Adds the field data SensorPositions.
void lms3dAddSensorPositions(const std::vector<lms3dVector>& positions, vtkPolyData* output);

#endif
