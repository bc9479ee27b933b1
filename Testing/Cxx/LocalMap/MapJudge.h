// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the parts of the judge of maps share.
 */
#ifndef MapJudge_h
#define MapJudge_h

#include "Fixtures/ScanGrid.h"
#include "Fixtures/TriangleTree.h"
#include "LocalMap/DepthSteps.h"
#include "LocalMap/MapLaws.h"

#include <string>
#include <vector>

class MapNeighbours;

/// A map under judgement. Coordinates are from the sensor, in axes parallel to the world's.
struct MapCase
{
  MapCase(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise);

  bool IsPlain() const { return this->Promise.MaximumError == 0.0; }
  /// The tolerance for rounding at a range, metres.
  static double GetRounding(double range) { return 1e-9 * range; }

  const MapPromise& Promise;
  const ScanGrid Grid;
  const DepthSteps Steps;
  vtkPolyData* Map;
  std::vector<Vector> Points;
  std::vector<TriangleTree::Triangle> Triangles;
};

/// The radians by which a beam may pass outside of a triangle that it meets.
constexpr double BeamMargin = 1e-9;

std::string ToWords(const Vector& point);

/// Points, triangles, edges and arrays.
void JudgeShape(const MapCase& map, MapVerdict& verdict);
/// Edges alone, which the laws of boundaries need to be sound.
void JudgeEdges(const MapCase& map, MapVerdict& verdict);
/// Distances from returns, and what beams and the rays between them hit.
void JudgeDistances(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict);
void JudgeBeams(const MapCase& map, const MapNeighbours& neighbours, const TriangleTree& surface,
  MapVerdict& verdict);
void JudgeDepthSteps(const MapCase& map, const MapNeighbours& neighbours,
  const TriangleTree& surface, MapVerdict& verdict);
/// The field data of the map. The verdict must contain the deviations already.
void JudgeFieldData(const MapCase& map, MapVerdict& verdict);

#endif
