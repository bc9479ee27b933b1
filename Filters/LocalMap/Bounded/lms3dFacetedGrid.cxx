// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dFacetedGrid.h"

#include "LocalMap/Grid/lms3dGridMesher.h"
#include "LocalMap/Grid/lms3dGridPoints.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr lms3dBeamSphere::GridIndex NoIndex = -1;
} // namespace

// The grid index of each vertex, or NoIndex for a return beyond the axis.
std::vector<lms3dFacetedGrid::GridIndex> lms3dFacetedGrid::FindIndices() const
{
  std::vector<GridIndex> indices(this->Grid.GetReturns().size(), NoIndex);
  for (GridIndex index = 0; index < this->Sphere.GetSize(); ++index)
  {
    const int turn = this->Sphere.GetTurn(index);
    if (turn >= 0 && this->Sphere.HasReturn(index))
    {
      indices[this->Grid.GetVertex(turn, this->Sphere.GetBeam(index))] = index;
    }
  }
  return indices;
}

// The triangles of the plain grid, three numbers each.
std::vector<std::int32_t> lms3dFacetedGrid::MakeTriangles(const lms3dBoundedMap& map) const
{
  lms3dGridPoints points;
  points.SetShape(this->Grid);
  for (int turn = 0; turn < this->Grid.GetNumberOfTurns(); ++turn)
  {
    for (int beam = 0; beam < this->Grid.GetNumberOfBeams(); ++beam)
    {
      const std::int32_t vertex = this->Grid.GetVertex(turn, beam);
      for (int axis = 0; axis < 3 && vertex != lms3dRangeGrid::NoVertex; ++axis)
      {
        points.GetRow(axis, turn)[beam] = map.Points[vertex][axis];
      }
    }
  }
  points.FillHalo(this->Grid);
  lms3dGridMesher mesher;
  mesher.SelectTriangles(this->Grid, this->Joins, points);
  std::vector<std::int32_t> corners(3 * mesher.GetNumberOfTriangles());
  mesher.FillTriangles(this->Grid, corners.data());
  return corners;
}

// Returns which vertices belong to a triangle.
std::vector<bool> lms3dFacetedGrid::AddTriangles(lms3dBoundedMap& map) const
{
  const std::vector<std::int32_t> corners = this->MakeTriangles(map);
  const bool isMirrored = this->Grid.GetGeometry().IsMirrored();
  std::vector<bool> isUsed(map.Points.size(), false);
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::array<std::int32_t, 3> triangle = { corners[i], corners[i + 1], corners[i + 2] };
    if (isMirrored)
    {
      std::swap(triangle[1], triangle[2]);
    }
    // In a cell that is wider than half a circle, a triangle can face away from the sensor.
    if (map.IsFacing(triangle))
    {
      map.Triangles.push_back(triangle);
      for (std::int32_t corner : triangle)
      {
        isUsed[corner] = true;
      }
    }
  }
  return isUsed;
}

lms3dBoundedMap lms3dFacetedGrid::MakeMap() const
{
  const std::vector<GridIndex> indices = this->FindIndices();
  lms3dBoundedMap map;
  map.Points.reserve(indices.size());
  for (GridIndex index : indices)
  {
    map.Points.push_back(index == NoIndex
        ? lms3dVector{ 0.0, 0.0, 0.0 }
        : lms3dScale(this->Sphere.GetDirection(index), this->Sphere.GetRange(index)));
  }
  const std::vector<bool> isUsed = this->AddTriangles(map);
  map.PatchIds.assign(map.Triangles.size(), lms3dBoundedMap::NoPatch);
  map.ReturnsOnGrid = std::count(isUsed.begin(), isUsed.end(), true);
  for (std::size_t vertex = 0; vertex < isUsed.size(); ++vertex)
  {
    if (!isUsed[vertex] && indices[vertex] != NoIndex)
    {
      map.AddFacet(this->Sphere, indices[vertex], this->Sphere.GetRange(indices[vertex]));
      ++map.ReturnsOnFacets;
    }
  }
  map.RemoveUnusedPoints();
  return map;
}
