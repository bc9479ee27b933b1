// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan as a vtkPolyData: names, types and order of its arrays.
 *
 * Output 0 of vtkLMS3DScanFilter has this layout, and so has a scan that comes from a server. The
 * array CellId is not part of it: a scan from a server has none.
 */
#ifndef lms3dReturns_h
#define lms3dReturns_h

#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dArray.h"
#include "Pipeline/lms3dPooledArray.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkTypeInt32Array.h>

class vtkPolyData;

/**
 * Arrays with one slot for each return, ordered by turn, then by beam.
 *
 * Fill all slots of Point, Range, Alpha, Beta and BeamId through the pointers, and all vertices by
 * FillVertices. Threads can fill different slots at the same time. MoveTo reads no slot, so it may
 * run before threads fill them, or meanwhile. The arrays own the memory that the pointers refer
 * to.
 */
struct lms3dReturns
{
  /// The values are not initialized. The memory is VTK's, or, if `pool` is given, that of the pool.
  template <typename... PoolT>
  explicit lms3dReturns(vtkIdType count, PoolT&... pool)
    : lms3dReturns(lms3dMakeArray<vtkDoubleArray>(pool..., "Range", count), pool...)
  {
  }

  /// Shares an array of ranges, which has one for each return.
  template <typename... PoolT>
  explicit lms3dReturns(const vtkSmartPointer<vtkDoubleArray>& ranges, PoolT&... pool)
    : Count(ranges->GetNumberOfValues())
    , Points(lms3dMakeArray<vtkDoubleArray>(pool..., "Points", this->Count, 3))
    , Ranges(ranges)
    , Alphas(lms3dMakeArray<vtkFloatArray>(pool..., "Alpha", this->Count))
    , Betas(lms3dMakeArray<vtkFloatArray>(pool..., "Beta", this->Count))
    , BeamIds(lms3dMakeArray<vtkIntArray>(pool..., "BeamId", this->Count))
    , VertexOffsets(lms3dMakeArray<vtkTypeInt32Array>(pool..., "Offsets", this->Count + 1))
    , VertexPoints(lms3dMakeArray<vtkTypeInt32Array>(pool..., "Connectivity", this->Count))
    , Point(this->Points->GetPointer(0))
    , Range(this->Ranges->GetPointer(0))
    , Alpha(this->Alphas->GetPointer(0))
    , Beta(this->Betas->GetPointer(0))
    , BeamId(this->BeamIds->GetPointer(0))
  {
  }

  /// Fills the vertex cells of the slots from `first` up to, but not including, `last`.
  void FillVertices(vtkIdType first, vtkIdType last) const;

  /// Sets the points, vertices, point data and field data of an empty `scan`, which then shares the
  /// arrays. `geometry` is the grid of the whole scan, with the beams that gave no return.
  void MoveTo(const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkPolyData* scan) const;

  const vtkIdType Count;
  const vtkSmartPointer<vtkDoubleArray> Points;
  const vtkSmartPointer<vtkDoubleArray> Ranges;
  const vtkSmartPointer<vtkFloatArray> Alphas;
  const vtkSmartPointer<vtkFloatArray> Betas;
  const vtkSmartPointer<vtkIntArray> BeamIds;
  const vtkSmartPointer<vtkTypeInt32Array> VertexOffsets;
  const vtkSmartPointer<vtkTypeInt32Array> VertexPoints;

  /// World coordinates, metres, three for each return.
  double* const Point;

  /// Metres.
  double* const Range;

  ///@{
  /// The angles of the beam, degrees.
  float* const Alpha;
  float* const Beta;
  ///@}

  /// turn * beams + beam.
  int* const BeamId;
};

#endif
