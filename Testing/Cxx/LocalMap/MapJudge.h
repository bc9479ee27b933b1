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

#include <memory>
#include <set>
#include <string>
#include <vector>

class MapNeighbours;

/// A map under judgement. Coordinates are from the sensor, in axes parallel to the world's.
struct MapCase
{
  MapCase(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise);

  /// The same map and the scan without errors, null if there is none.
  std::unique_ptr<const MapCase> MakeIdeal() const;

  bool IsPlain() const { return this->Promise.MaximumError == 0.0; }
  /// Whether the map names the return of a beam as that of a speckle, which is no part of the
  /// surface around it.
  bool IsSpeckle(const ScanGrid::Beam& beam) const
  {
    return this->Speckles.count(beam.Turn * this->Grid.GetNumberOfBeams() + beam.Number) > 0;
  }
  /// The tolerance for rounding at a range, metres.
  static double GetRounding(double range) { return 1e-9 * range; }

  const MapPromise& Promise;
  const ScanGrid Grid;
  const DepthSteps Steps;
  vtkPolyData* Scan;
  vtkPolyData* Map;
  std::set<int> Speckles;
  std::vector<Vector> Points;
  std::vector<TriangleTree::Triangle> Triangles;
};

/// The radians by which a beam may pass outside of a triangle that it meets.
constexpr double BeamMargin = 1e-9;

std::string ToWords(const Vector& point);

/// The numbers that an array of the field data has; none if there is no such array.
std::set<int> GetFieldNumbers(vtkPolyData* map, const char* name);

/// Points, triangles, edges and arrays.
void JudgeShape(const MapCase& map, MapVerdict& verdict);
/// Edges alone, which the laws of boundaries need to be sound.
void JudgeEdges(const MapCase& map, MapVerdict& verdict);
/// Whether a triangle that shares no edge is the facet of returns at a pole that one vertex cannot
/// represent.
bool IsFacetOfPole(const MapCase& map, const TriangleTree::Triangle& triangle);
/// Distances from returns, and what beams and the rays between them hit.
void JudgeDistances(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict);
void JudgeBeams(const MapCase& map, const MapNeighbours& neighbours, const TriangleTree& surface,
  MapVerdict& verdict);
void JudgeDepthSteps(const MapCase& map, const MapNeighbours& neighbours,
  const TriangleTree& surface, MapVerdict& verdict);
/// The field data of the map. The verdict must contain the deviations already.
void JudgeFieldData(const MapCase& map, MapVerdict& verdict);

/// Beams without a return that meet surface, in gaps that are closed and elsewhere.
void JudgeGaps(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict);
/// Returns beyond the bound, if speckles are left out, and the speckles that the map names.
void JudgeSpeckles(const MapCase& map, const TriangleTree& surface,
  const std::vector<vtkIdType>& leftOut, MapVerdict& verdict);

#endif
