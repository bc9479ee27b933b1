// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The laws of the local map, and a judge that finds where a map breaks them.
 *
 * The judge uses the scan, the map and, if there is one, the scene. It shares no code with the
 * filter. Lengths have a tolerance of 1e-9 of the range, directions of 1e-9 radians.
 *
 * - bound: no return is farther from the surface than MaximumError, also at poles. With a
 *   MaximumError of 0, each return is a vertex; a pole is one vertex, at its return of median
 *   range.
 * - beam: each beam that returned hits the surface. (In a plain grid, if its return has a triangle.
 *   Not if its return is a speckle that is left out.)
 * - free space: what a beam that returned hits is within MaximumError and the noise of the scene,
 *   or no farther from it than what joined neighbours span, as the plain grid is at a crease.
 * - between beams: there, where nothing was measured, the surface may be off by half a cell more. A
 *   bounded map, whose borders pass between beams, may be off by more at four places and one in a
 *   thousand. The surface may also continue in the plane that a neighbouring beam hit, or in the
 *   plane of that beam's return and two more of the same surface, within twice the bound: a plane
 *   that is off by the bound at one beam and by as much to the other side at the next is off by
 *   twice the bound half a cell further.
 * - miss: no beam without a return hits the surface.
 * - bridge: between neighbours on both sides of a depth step (of the scene, too, if there is a
 *   scene), the surface has a gap or a jump.
 * - crack: between four beams whose ranges are within DepthStep, there is surface.
 * - overhang: no vertex is a whole cell away from all returns.
 * - edge: at most two triangles share an edge, in opposite directions.
 * - boundary: an edge of one triangle lies at a depth step, a miss or the border of the scan. (Not
 *   if the triangle is the facet of returns at a pole that are farther than MaximumError from their
 *   median, while all returns of the pole span more than twice MaximumError.)
 * - T-junction: no vertex lies inside an edge.
 * - facing: each triangle faces the sensor.
 * - area: each triangle has an area and three corners.
 * - point: coordinates are finite, and each point belongs to a triangle. (Not in a plain grid.)
 * - range, normal: `Range` is the distance from the sensor. `Normals` of points are unit vectors
 *   towards it; `Normals` of triangles are the triangles' normals.
 * - field data: the field data of the map are right.
 *
 * If there is a scan without the errors of the first, surface may also be where this ideal scan and
 * the scene explain it. Then there are more laws:
 *
 * - miss: gaps that the filter may close can have surface: groups of at most MaximumGapSize beams
 *   without a return, away from the edge of the scan, if no beam of the group met nothing or a
 *   surface beyond the range, by the scan's `Status`. (Beams are neighbours along the fan and along
 *   the turn.)
 * - closed gap: the field data name just these beams, and count their groups.
 * - passage: where such a gap is closed, no beam of the ideal scan meets a surface behind the map,
 *   farther than MaximumError and the noise from it.
 * - bridge: the surface does not join what lies apart in the ideal scan.
 * - speckle: the field data name and count the returns of speckles, groups of at most
 *   MaximumSpeckleSize neighbouring returns. Without KeepSpeckles, only these may exceed the bound.
 * - hole: where all returns around a speckle lie on one plane, within a quarter of the bound, the
 *   surface goes on behind the speckle, or before it: its beam meets surface within twice the bound
 *   of the plane.
 */
#ifndef MapLaws_h
#define MapLaws_h

#include <vtkType.h>

#include <cstddef>
#include <iosfwd>
#include <map>
#include <string>

class vtkPolyData;

/// The parameters of the laws.
struct MapPromise
{
  double MaximumError = 0.01;
  double DepthStep = 0.1;
  /// The triangles that were scanned, numbered as the scan's CellId, or none.
  vtkPolyData* Scene = nullptr;
  /// How far returns were moved along their beams, at most, except stray returns.
  double Noise = 0.0;
  /// The scan of the same beams without errors, or none.
  vtkPolyData* Ideal = nullptr;
  /// Properties of the filter.
  int MaximumGapSize = -1;
  int MaximumSpeckleSize = 0;
  bool KeepSpeckles = true;
};

class MapVerdict
{
public:
  /// Adds a breach of a law. The description of the worst breach of each law is kept.
  void Add(const std::string& law, const std::string& words, double amount = 0.0);

  /// Removes the breaches of a law if there are at most `count`.
  void Allow(const std::string& law, double count);

  bool IsLawful() const { return this->Breaches.empty(); }
  std::size_t GetNumberOfBreaches(const std::string& law) const;

  /// Metres: the largest distance from a return to the surface; of a plain grid to a vertex.
  double LargestDeviation = 0.0;
  /// The same from the nearest triangle that the return's own beam hits.
  double LargestDeviationOnBeams = 0.0;
  vtkIdType NumberOfBoundaryEdges = 0;
  vtkIdType EulerCharacteristic = 0;

private:
  struct Breach
  {
    std::size_t Count = 0;
    double Amount = 0.0;
    std::string Words;
  };
  std::map<std::string, Breach> Breaches;

  friend std::ostream& operator<<(std::ostream& os, const MapVerdict& verdict);
};

MapVerdict JudgeMap(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise);

#endif
