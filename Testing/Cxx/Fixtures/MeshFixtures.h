// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes for tests below VTK.
 */
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "Fixtures/VectorFixtures.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <vector>

lms3dTriangleMesh MakeMesh(const std::vector<std::array<Vector, 3>>& triangles);
/// An icosahedron of radius 1 whose triangles are quartered `level` times.
lms3dTriangleMesh MakeIcosphere(int level);
/// From -1 to 1, each side of cells x cells squares, two triangles each.
lms3dTriangleMesh MakeCube(int cells);
/// Boxes of 2 x 2 x 2 whose corners are whole numbers: some share faces, edges or corners.
lms3dTriangleMesh MakeBlocks();
/// An upright wall, a metre high, of 400 triangles that are `aspect` times longer than wide.
lms3dTriangleMesh MakeNeedleWall(double aspect);
/// A triangle beside two that end in the middle of its first side, its middle off the side by
/// rounding. Each triangle has points of its own.
lms3dTriangleMesh MakeTJunction();
/// The triangles of a surface that has nothing else.
lms3dTriangleMesh MakeMesh(vtkPolyData* surface);
/// The same the other way round.
vtkSmartPointer<vtkPolyData> MakeSurface(const lms3dTriangleMesh& mesh);
/// The sum of the triangles' areas.
double GetArea(const std::vector<std::array<Vector, 3>>& triangles);
void Append(const lms3dTriangleMesh& other, lms3dTriangleMesh& mesh);
lms3dTriangleMesh Map(lms3dTriangleMesh mesh, const std::function<Vector(const Vector&)>& map);
lms3dTriangleMesh Move(lms3dTriangleMesh mesh, double scale, const Vector& offset);
/// Whether each edge, identified by its coordinates, occurs equally often in both directions.
bool IsClosed(const lms3dTriangleMesh& mesh);

#endif
