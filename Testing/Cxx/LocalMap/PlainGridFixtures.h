// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Plain grids of scenes, the edges of their triangles, and errors of the reconstruction.
 */
#ifndef PlainGridFixtures_h
#define PlainGridFixtures_h

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <set>
#include <string>
#include <utility>

/// A scan of a scene, and the plain grid of the scan.
struct PlainGridPipeline
{
  explicit PlainGridPipeline(vtkDataObject* scene);

  /// Updates, and returns the grid.
  vtkPolyData* Run();

  vtkNew<vtkLMS3DScanFilter> Scan;
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> Map;
};

/// Updates the filter, and returns a copy of its scan.
vtkSmartPointer<vtkPolyData> CopyScan(vtkLMS3DScanFilter* scan);

using Edge = std::pair<vtkIdType, vtkIdType>;

/// The directed edges of the triangles. Fails the test if an edge occurs twice.
std::set<Edge> GetDirectedEdges(vtkPolyData* map);

vtkIdType CountBoundaryEdges(const std::set<Edge>& edges);

/// Expects an error that contains some words and no output, for a plain grid and a bounded map.
void ExpectRefused(vtkPolyData* scan, const std::string& words);

#endif
