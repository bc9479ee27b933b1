// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Geometry/lms3dAngle.h"

#include "vtkVRMLImporterSource.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
BenchmarkScene ReadScene(const std::string& name, const std::array<double, 3>& sensor)
{
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName((LMS3D_DATA_DIR "/" + name + ".wrl").c_str());
  reader->Update();
  return { name, reader->GetOutput(), sensor };
}

/// Collects triangles.
class Builder
{
public:
  vtkIdType AddPoint(double x, double y, double z)
  {
    return this->Points->InsertNextPoint(x, y, z);
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType corners[3] = { a, b, c };
    this->Triangles->InsertNextCell(3, corners);
  }

  void AddQuad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    this->AddTriangle(a, b, c);
    this->AddTriangle(a, c, d);
  }

  /// An upright prism with a regular polygon as base, turned by half a side.
  void AddPrism(int sides, const std::array<double, 2>& centre,
    const std::array<double, 2>& halfSize, double bottom, double top)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * lms3dPi * (i + 0.5) / sides;
      const double x = centre[0] + halfSize[0] * std::cos(angle) / std::cos(lms3dPi / sides);
      const double y = centre[1] + halfSize[1] * std::sin(angle) / std::cos(lms3dPi / sides);
      this->AddPoint(x, y, bottom);
      this->AddPoint(x, y, top);
    }
    for (int i = 0; i < sides; ++i)
    {
      const vtkIdType here = first + 2 * i;
      const vtkIdType next = first + 2 * ((i + 1) % sides);
      this->AddQuad(here, next, next + 1, here + 1);
    }
    for (int i = 1; i + 1 < sides; ++i)
    {
      this->AddTriangle(first, first + 2 * i, first + 2 * i + 2);
      this->AddTriangle(first + 1, first + 2 * i + 1, first + 2 * i + 3);
    }
  }

  vtkSmartPointer<vtkPolyData> GetSurface() const
  {
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Triangles);
    return surface;
  }

  void Allocate(vtkIdType points, vtkIdType triangles)
  {
    this->Points->Allocate(points);
    this->Triangles->AllocateExact(triangles, 3 * triangles);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
};

BenchmarkScene MakeCastle()
{
  constexpr double Reach = 20.0; // from the yard's middle to a tower's
  Builder builder;
  builder.AddPrism(4, { 0.0, 0.0 }, { 30.0, 30.0 }, 0.0, 25.0);
  for (int side = 0; side < 4; ++side)
  {
    const double x = side % 2 == 0 ? (side == 0 ? 1.0 : -1.0) : 0.0;
    const double y = side % 2 == 1 ? (side == 1 ? 1.0 : -1.0) : 0.0;
    const double alongX = std::abs(y);
    const double alongY = std::abs(x);
    builder.AddPrism(4, { Reach * x, Reach * y },
      { 0.5 + (Reach - 0.5) * alongX, 0.5 + (Reach - 0.5) * alongY }, 0.0, 6.0);
    for (int merlon = -4; merlon <= 4; ++merlon)
    {
      const double place = 3.5 * merlon;
      builder.AddPrism(4, { Reach * x + place * alongX, Reach * y + place * alongY },
        { 0.5 + 0.4 * alongX, 0.5 + 0.4 * alongY }, 6.0, 7.2);
    }
    const double diagonalX = side < 2 ? 1.0 : -1.0;
    const double diagonalY = side % 2 == 0 ? 1.0 : -1.0;
    builder.AddPrism(32, { Reach * diagonalX, Reach * diagonalY }, { 3.0, 3.0 }, 0.0, 11.0);
  }
  return { "castle", builder.GetSurface(), { 0.31, -0.73, 1.7 } };
}

BenchmarkScene MakeBall()
{
  constexpr double Radius = 2.0;
  constexpr int Sides = 512;
  constexpr int Rings = 256;
  Builder builder;
  const auto addPoint = [&](double polar, double angle)
  {
    return builder.AddPoint(Radius * std::sin(polar) * std::cos(angle),
      Radius * std::sin(polar) * std::sin(angle), Radius * std::cos(polar));
  };
  const vtkIdType top = addPoint(0.0, 0.0);
  const vtkIdType bottom = addPoint(lms3dPi, 0.0);
  const vtkIdType first = bottom + 1;
  for (int ring = 1; ring < Rings; ++ring)
  {
    for (int side = 0; side < Sides; ++side)
    {
      addPoint(lms3dPi * ring / Rings, 2.0 * lms3dPi * side / Sides);
    }
  }
  constexpr vtkIdType Last = static_cast<vtkIdType>(Sides) * (Rings - 2);
  for (int side = 0; side < Sides; ++side)
  {
    const vtkIdType here = first + side;
    const vtkIdType next = first + (side + 1) % Sides;
    builder.AddTriangle(top, here, next);
    for (vtkIdType ring = 0; ring < Last; ring += Sides)
    {
      builder.AddQuad(here + ring, here + ring + Sides, next + ring + Sides, next + ring);
    }
    builder.AddTriangle(bottom, next + Last, here + Last);
  }
  return { "ball", builder.GetSurface(), { 0.31, -0.23, 0.17 } };
}

double GetHeight(double x, double y)
{
  double height = 0.0;
  double length = 60.0;
  double amplitude = 4.0;
  for (int octave = 0; octave < 6; ++octave, length *= 0.45, amplitude *= 0.4)
  {
    const double u = x * std::cos(octave) + y * std::sin(octave);
    const double v = y * std::cos(octave) - x * std::sin(octave);
    height += amplitude * std::sin(2.0 * lms3dPi * u / length + octave) *
      std::cos(2.0 * lms3dPi * v / length + 2.0 * octave);
  }
  return height;
}

BenchmarkScene MakeTerrain(const std::string& name, int columns, int rows)
{
  constexpr double Size = 200.0;
  Builder builder;
  builder.Allocate(
    static_cast<vtkIdType>(columns + 1) * (rows + 1), static_cast<vtkIdType>(columns) * rows * 2);
  for (int row = 0; row <= rows; ++row)
  {
    for (int column = 0; column <= columns; ++column)
    {
      const double x = Size * (static_cast<double>(column) / columns - 0.5);
      const double y = Size * (static_cast<double>(row) / rows - 0.5);
      const vtkIdType point = builder.AddPoint(x, y, GetHeight(x, y));
      if (row < rows && column < columns)
      {
        builder.AddQuad(point, point + 1, point + columns + 2, point + columns + 1);
      }
    }
  }
  const double x = 0.013;
  const double y = 0.021;
  return { name, builder.GetSurface(), { x, y, GetHeight(x, y) + 2.0 } };
}

std::string GetTerrainName(int power)
{
  return "terrain1e" + std::to_string(power);
}
} // namespace

const std::vector<std::string>& GetSceneNames()
{
  static const std::vector<std::string> names = { "room", "castle", "teapot", "ball", "terrain1e3",
    "terrain1e4", "terrain1e5", "terrain1e6", "terrain1e7" };
  return names;
}

BenchmarkScene MakeScene(const std::string& name)
{
  if (name == "room")
  {
    return ReadScene(name, { 0.3, -0.2, 1.0 });
  }
  if (name == "teapot")
  {
    BenchmarkScene teapot = ReadScene(name, { 0.10, -0.33, 0.30 });
    teapot.DepthStep = 0.02;
    return teapot;
  }
  if (name == "castle")
  {
    return MakeCastle();
  }
  if (name == "ball")
  {
    return MakeBall();
  }
  for (int power = 3; power <= 7; ++power)
  {
    if (name == GetTerrainName(power))
    {
      return MakeTerrain(power);
    }
  }
  throw std::runtime_error("no scene \"" + name + "\"");
}

BenchmarkScene MakeTerrain(int power)
{
  constexpr std::array<std::array<int, 2>, 6> grids = { { { 5, 10 }, { 20, 25 }, { 50, 100 },
    { 200, 250 }, { 500, 1000 }, { 2000, 2500 } } };
  const auto [columns, rows] = grids.at(power - 2);
  return MakeTerrain(GetTerrainName(power), columns, rows);
}
