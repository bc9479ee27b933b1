// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers, vectors and meshes for tests below VTK.
 */
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "Geometry/lms3dTriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

using Vector = std::array<double, 3>;

/// The same sequence everywhere for the same seed (SplitMix64).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  /// All 64 bits.
  std::uint64_t GetBits();
  /// From 0 up to, not including, 1.
  double Get() { return static_cast<double>(this->GetBits() >> 11) * 0x1p-53; }
  double Get(double low, double high) { return low + (high - low) * this->Get(); }
  /// A vector on the unit sphere.
  Vector GetDirection();

private:
  std::uint64_t State;
};

Vector operator+(const Vector& p, const Vector& q);
Vector operator-(const Vector& p, const Vector& q);
Vector operator*(double factor, const Vector& p);
double GetLength(const Vector& p);
Vector Normalize(const Vector& p);
/// Turned by two angles that are not multiples of a simple fraction of a circle.
Vector Turn(const Vector& p);

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
void Append(const lms3dTriangleMesh& other, lms3dTriangleMesh& mesh);
lms3dTriangleMesh Map(lms3dTriangleMesh mesh, const std::function<Vector(const Vector&)>& map);
lms3dTriangleMesh Move(lms3dTriangleMesh mesh, double scale, const Vector& offset);
/// Whether each edge, identified by its coordinates, occurs equally often in both directions.
bool IsClosed(const lms3dTriangleMesh& mesh);

#endif
