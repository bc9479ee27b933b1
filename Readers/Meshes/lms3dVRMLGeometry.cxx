// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dVRMLGeometry.h"

#include "Geometry/lms3dVector.h"
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

lms3dMesh lms3dMakeMesh(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry, int sides)
{
  switch (geometry.Node->Type->Role)
  {
    case lms3dVRMLNodeType::BOX:
      return lms3dMakeBox(evaluator, geometry);
    case lms3dVRMLNodeType::CONE:
      return lms3dMakeCone(evaluator, geometry, sides);
    case lms3dVRMLNodeType::CYLINDER:
      return lms3dMakeCylinder(evaluator, geometry, sides);
    case lms3dVRMLNodeType::ELEVATION_GRID:
      return lms3dMakeElevationGrid(evaluator, geometry);
    case lms3dVRMLNodeType::EXTRUSION:
      return lms3dMakeExtrusion(evaluator, geometry);
    case lms3dVRMLNodeType::INDEXED_FACE_SET:
      return lms3dMakeFaceSet(evaluator, geometry);
    case lms3dVRMLNodeType::SPHERE:
      return lms3dMakeSphere(evaluator, geometry, sides);
    default:
      return {};
  }
}

void lms3dAddQuadrilateral(const std::array<std::int32_t, 4>& corners, lms3dMesh& mesh)
{
  for (const std::array<std::int32_t, 3>& triangle :
    { std::array<std::int32_t, 3>{ corners[0], corners[1], corners[2] },
      std::array<std::int32_t, 3>{ corners[0], corners[2], corners[3] } })
  {
    const lms3dPoint& a = mesh.Points[triangle[0]];
    const lms3dPoint& b = mesh.Points[triangle[1]];
    const lms3dPoint& c = mesh.Points[triangle[2]];
    if (a != b && b != c && c != a)
    {
      mesh.Triangles.push_back(triangle);
    }
  }
}

void lms3dFlip(lms3dMesh& mesh)
{
  for (std::array<std::int32_t, 3>& triangle : mesh.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

double lms3dGetLargestCoordinate(const lms3dMesh& mesh)
{
  double largest = 0.0;
  for (const lms3dPoint& point : mesh.Points)
  {
    if (!lms3dIsFinite(point))
    {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max({ largest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
  }
  return largest;
}
