// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan: the points of output 0 and their arrays.
 */
#ifndef lms3dReturns_h
#define lms3dReturns_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Pipeline/lms3dMemoryPool.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkTypeInt32Array.h>

#include <array>
#include <cstddef>
#include <cstdint>

class vtkPolyData;

/// Where the returns go: a slot for each in every array.
struct lms3dReturns
{
  lms3dReturns(lms3dMemoryPool& pool, vtkIdType count);

  /// To be called once all slots are filled.
  void MoveTo(vtkPolyData* scan) const;

  const vtkSmartPointer<vtkDoubleArray> Points;
  const vtkSmartPointer<vtkDoubleArray> Ranges;
  const vtkSmartPointer<vtkFloatArray> Alphas;
  const vtkSmartPointer<vtkFloatArray> Betas;
  const vtkSmartPointer<vtkIntArray> BeamIds;
  const vtkSmartPointer<vtkIdTypeArray> CellIds;
  const vtkSmartPointer<vtkTypeInt32Array> VertexOffsets;
  const vtkSmartPointer<vtkTypeInt32Array> VertexPoints;

  double* const Point;
  double* const Range;
  float* const Alpha;
  float* const Beta;
  int* const BeamId;
  vtkIdType* const CellId;
  vtkTypeInt32* const VertexOffset;
  vtkTypeInt32* const VertexPoint;
};

/// What is known of one turn. Ranges, triangles and cells are those of its beams.
struct lms3dTurn
{
  /// Fills the slots of the turn's returns, from the first on.
  void Fill(std::size_t slot, const lms3dReturns& returns) const;

  const lms3dScanGeometry& Geometry;
  const lms3dBeamDirections& Directions;
  const std::array<double, 3>& Position;
  const int Number;
  const double* const Ranges;

  /// lms3dBeamPacket::NoTriangle where there is no return.
  const std::int32_t* const Triangles;

  /// Tells the triangles' cells; null where Cells does.
  const lms3dTriangleMesh* const Mesh;
  const vtkIdType* const Cells;
};

#endif
