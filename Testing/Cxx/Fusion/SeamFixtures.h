// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gaps between the regions of a fused map, and whether the map is closed.
 */
#ifndef SeamFixtures_h
#define SeamFixtures_h

#include "Fusion/FusionFixtures.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

struct Seams
{
  int Samples = 0;
  /// Samples on the borders of regions without another region within the bound, where the region
  /// does not go on behind a gap of three bounds either.
  int Open = 0;
  /// Samples without another region within a tenth of the bound.
  int Loose = 0;
};

/// Looks from the borders of regions for other regions, every 2 cm. What is farther than the bound
/// from the scene, such as the facets of strays, is left out.
Seams FindSeams(vtkPolyData* fused, vtkPolyData* scene, double bound);

/// How often the map surrounds a point: the sum of the solid angles of its triangles (A. van
/// Oosterom and J. Strackee 1983, "The solid angle of a plane triangle"), as a share of the sphere.
double CountSheetsAround(vtkPolyData* fused, const Vector& place);

/// A map whose vertices are joined if they are nearer to one another than a micrometre. An edge is
/// divided at the vertices that lie on it.
class JoinedMap
{
public:
  explicit JoinedMap(vtkPolyData* map);

  /// Vertices less edges plus triangles. A triangle with vertices on its edges counts once.
  int GetEulerNumber() const;

  /// The edges that do not have one triangle on each side.
  int CountOpenEdges() const;

private:
  int Find(const Vector& point);
  /// Adds the parts between the vertices that lie on an edge.
  void AddEdge(int from, int to);

  std::vector<Vector> Vertices;
  std::vector<std::array<int, 3>> Triangles;
  /// How many triangles have each edge in each of its directions.
  std::map<std::pair<int, int>, std::array<int, 2>> Edges;
};

#endif
