// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans with their local maps, and a judge of the map that joins them.
 */
#ifndef FusionFixtures_h
#define FusionFixtures_h

#include "Fixtures/SceneFixtures.h"
#include "Fixtures/TriangleTree.h"

#include "vtkLMS3DMapFusion.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

/// A scan and its local map.
struct MappedScan
{
  vtkSmartPointer<vtkPolyData> Scan;
  vtkSmartPointer<vtkPolyData> Map;
};

/// Scans a scene with 361 x 360 beams, or with 91 x 90 if `isCoarse`. `noise` is in metres.
MappedScan MakeMappedScan(
  vtkPolyData* scene, const Point& position, bool isCoarse = true, double noise = 0.0);

/// Five poses in Data/room.wrl, on both sides of its furniture.
std::vector<MappedScan> ScanRoom(bool isCoarse = true, double noise = 0.0);

/// Coarse scans of poses anywhere in Data/room.wrl.
std::vector<MappedScan> ScanRoomAnywhere(int count);

/// Moves the returns, the pose and the map by an error of the pose, metres.
void Move(const Point& error, MappedScan& scan);

/// Adds all scans. Fails the test if one is refused.
void AddAll(const std::vector<MappedScan>& scans, vtkLMS3DMapFusion* fusion);

vtkIdType CountTriangles(const std::vector<MappedScan>& scans);

/// The triangles of a map, relative to a point.
TriangleTree MakeTree(vtkPolyData* map, const Point& origin);

/// What the returns of a scan say about a map. The judge shares no code with the filter.
struct FusionVerdict
{
  vtkIdType Returns = 0;
  /// Returns farther than the bound from all triangles, and the largest distance, metres.
  vtkIdType Beyond = 0;
  double LargestDistance = 0.0;
  /// Beams that meet a triangle nearer than their return by more than the bound.
  vtkIdType Blocked = 0;
  /// Beams that meet no triangle nearer than their return by the bound or less, or behind it by
  /// that.
  vtkIdType Missed = 0;
};

/// Judges the returns that the local map keeps: those within the bound of it.
FusionVerdict JudgeFusion(vtkPolyData* fused, const MappedScan& scan, double maximumError);

/// The sum for several scans.
FusionVerdict JudgeFusion(
  vtkPolyData* fused, const std::vector<MappedScan>& scans, double maximumError);

#endif
