// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/MeshFixtures.h"

#include "Geometry/lms3dVector.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace
{
using Triangles = lms3dTriangleIndices;

// Each triangle as four, with its corners and the middles of its edges, all at a distance of 1.
lms3dTriangleMesh Quarter(const lms3dTriangleMesh& mesh)
{
  lms3dTriangleMesh finer;
  finer.Points = mesh.Points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto getMiddle = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto [place, isNew] =
      middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.Points.size()));
    if (isNew)
    {
      finer.Points.push_back(Normalize(mesh.Points[a] + mesh.Points[b]));
    }
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const std::uint32_t ab = getMiddle(a, b);
    const std::uint32_t bc = getMiddle(b, c);
    const std::uint32_t ca = getMiddle(c, a);
    for (const auto& triangle :
      Triangles{ { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } })
    {
      finer.Triangles.push_back(triangle);
    }
  }
  return finer;
}

lms3dTriangleMesh MakeIcosahedron()
{
  const double g = 0.5 + std::sqrt(1.25);
  lms3dTriangleMesh mesh;
  mesh.Points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
    { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  std::transform(mesh.Points.begin(), mesh.Points.end(), mesh.Points.begin(), Normalize);
  mesh.Triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  return mesh;
}
} // namespace

lms3dTriangleMesh MakeMesh(const std::vector<std::array<Vector, 3>>& triangles)
{
  lms3dTriangleMesh mesh;
  for (const std::array<Vector, 3>& triangle : triangles)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(mesh.Points.size());
    mesh.Points.insert(mesh.Points.end(), triangle.begin(), triangle.end());
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}

lms3dTriangleMesh MakeIcosphere(int level)
{
  lms3dTriangleMesh mesh = MakeIcosahedron();
  for (int i = 0; i < level; ++i)
  {
    mesh = Quarter(mesh);
  }
  return mesh;
}

lms3dTriangleMesh MakeCube(int cells)
{
  std::vector<std::array<Vector, 3>> triangles;
  const auto getPoint = [cells](int axis, double side, int i, int j)
  {
    Vector p;
    p[axis] = side;
    p[(axis + 1) % 3] = double(2 * i - cells) / cells;
    p[(axis + 2) % 3] = side * double(2 * j - cells) / cells;
    return p;
  };
  for (int side = 0; side < 6; ++side)
  {
    for (int cell = 0; cell < cells * cells; ++cell)
    {
      const int i = cell / cells;
      const int j = cell % cells;
      const double sign = side < 3 ? -1.0 : 1.0;
      const Vector a = getPoint(side % 3, sign, i, j);
      const Vector c = getPoint(side % 3, sign, i + 1, j + 1);
      triangles.push_back({ a, getPoint(side % 3, sign, i + 1, j), c });
      triangles.push_back({ a, c, getPoint(side % 3, sign, i, j + 1) });
    }
  }
  return MakeMesh(triangles);
}

lms3dTriangleMesh MakeBlocks()
{
  lms3dTriangleMesh blocks;
  Random random(1);
  const auto getPlace = [&random] { return static_cast<double>(random.GetBits() % 6) * 2.0 - 5.0; };
  for (int i = 0; i < 30; ++i)
  {
    Append(Move(MakeCube(1), 1.0, { getPlace(), getPlace(), getPlace() }), blocks);
  }
  return blocks;
}

lms3dTriangleMesh MakeNeedleWall(double aspect)
{
  lms3dTriangleMesh mesh;
  for (int i = 0; i <= 200; ++i)
  {
    const double x = (i - 100) / aspect;
    mesh.Points.push_back({ x, 1.0, -0.5 });
    mesh.Points.push_back({ x, 1.0, 0.5 });
  }
  for (std::uint32_t i = 0; i < 400; i += 2)
  {
    mesh.Triangles.push_back({ i, i + 2, i + 1 });
    mesh.Triangles.push_back({ i + 1, i + 2, i + 3 });
  }
  return mesh;
}

lms3dTriangleMesh MakeTJunction()
{
  const Vector a = Turn({ -1.0, 2.0, -1.0 });
  const Vector b = Turn({ 1.1, 2.0, 1.3 });
  const Vector middle = a + 0.37 * (b - a);
  const Vector left = Turn({ -1.0, 2.0, 1.0 });
  const Vector right = Turn({ 1.0, 2.0, -1.0 });
  return MakeMesh({ { { a, b, left } }, { { a, middle, right } }, { { middle, b, right } } });
}

vtkSmartPointer<vtkPolyData> MakeSurface(const lms3dTriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    triangles->InsertNextCell({ vtkIdType(a), vtkIdType(b), vtkIdType(c) });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

lms3dTriangleMesh MakeMesh(vtkPolyData* surface)
{
  lms3dTriangleMesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, mesh.Points.emplace_back().data());
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdList* corners = surface->GetCell(i)->GetPointIds();
    mesh.Triangles.push_back({ static_cast<std::uint32_t>(corners->GetId(0)),
      static_cast<std::uint32_t>(corners->GetId(1)),
      static_cast<std::uint32_t>(corners->GetId(2)) });
  }
  return mesh;
}

double GetArea(const std::vector<std::array<Vector, 3>>& triangles)
{
  double area = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    area += 0.5 * lms3dGetLength(lms3dCross(b - a, c - a));
  }
  return area;
}

void Append(const lms3dTriangleMesh& other, lms3dTriangleMesh& mesh)
{
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& [a, b, c] : other.Triangles)
  {
    mesh.Triangles.push_back({ first + a, first + b, first + c });
  }
}

lms3dTriangleMesh Map(lms3dTriangleMesh mesh, const std::function<Vector(const Vector&)>& map)
{
  std::transform(mesh.Points.begin(), mesh.Points.end(), mesh.Points.begin(), map);
  return mesh;
}

lms3dTriangleMesh Move(lms3dTriangleMesh mesh, double scale, const Vector& offset)
{
  return Map(std::move(mesh), [&](const Vector& p) { return scale * p + offset; });
}

bool IsClosed(const lms3dTriangleMesh& mesh)
{
  std::map<std::pair<Vector, Vector>, int> uses;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector& a = mesh.Points[triangle[i]];
      const Vector& b = mesh.Points[triangle[(i + 1) % 3]];
      uses[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
}
