// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CasterFixtures.h"

#include "lms3dPacketKernels.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkCell.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>
#include <utility>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The header of the filter leaves open which of two surfaces so near to one another is returned.
constexpr double TieMargin = 1e-13;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

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

// One beam of a packet that was cast.
Tally JudgeBeam(const Target& target, const Vector& origin, const Vector& direction,
  double measured, std::int32_t triangle)
{
  const ExactReference::Hit nearest = target.Reference.Cast(origin, direction);
  Tally tally;
  tally.Beams = 1;
  tally.Hits = nearest.Triangle != ExactReference::NoTriangle;
  if (triangle == lms3dBeamPacket::NoTriangle)
  {
    tally.Misses = tally.Hits;
    return tally;
  }
  const ExactReference::Hit own = target.Reference.Cast(triangle, origin, direction);
  if (own.Triangle != triangle || own.Range > nearest.Range * (1.0 + TieMargin))
  {
    tally.FalseHits = 1;
    return tally;
  }
  tally.WorstError = ExactReference::GetError(measured, own);
  return tally;
}
} // namespace

std::uint64_t Random::GetBits()
{
  this->State += 0x9e3779b97f4a7c15u;
  std::uint64_t bits = this->State;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

Vector Random::GetDirection()
{
  const double z = this->Get(-1.0, 1.0);
  const double angle = this->Get(0.0, 2.0 * vtkMath::Pi());
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

Vector operator+(const Vector& p, const Vector& q)
{
  return { p[0] + q[0], p[1] + q[1], p[2] + q[2] };
}

Vector operator-(const Vector& p, const Vector& q)
{
  return { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
}

Vector operator*(double factor, const Vector& p)
{
  return { factor * p[0], factor * p[1], factor * p[2] };
}

double GetLength(const Vector& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

Vector Normalize(const Vector& p)
{
  return (1.0 / GetLength(p)) * p;
}

Vector Turn(const Vector& p)
{
  const double a = 0.37;
  const double b = 1.13;
  const Vector q = { std::cos(a) * p[0] - std::sin(a) * p[1],
    std::sin(a) * p[0] + std::cos(a) * p[1], p[2] };
  return { q[0], std::cos(b) * q[1] - std::sin(b) * q[2], std::sin(b) * q[1] + std::cos(b) * q[2] };
}

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

lms3dBeamPacket Aim(const Beams& directions)
{
  lms3dElevations level;
  lms3dFanAxes axes;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    level.Cosine[i] = 1.0;
    level.Sine[i] = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      axes.Horizontal[axis][i] = directions[i][axis];
      axes.Up[axis] = 0.0;
    }
  }
  lms3dBeamPacket packet;
  lms3dGetPacketKernels().Aim(level, axes, packet);
  packet.Active = 0xffffu;
  return packet;
}

Target::Target(const lms3dTriangleMesh& mesh)
  : Caster(lms3dRayCaster::New(vtkLMS3DScanFilter::EXACT, mesh))
  , Reference(mesh.Points, mesh.Triangles)
{
}

Vector Target::See(const Vector& origin, std::size_t triangle, int corner) const
{
  const double* p = this->GetMesh().GetCorner(triangle, corner);
  return { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
}

Beams Target::AimAt(std::size_t triangle, const Vector& origin, Random& random) const
{
  constexpr int Corners = 1;
  constexpr int Edges = 4;
  Beams beams;
  const int first = static_cast<int>(random.GetBits() % 3);
  const Vector a = this->See(origin, triangle, first);
  const Vector b = this->See(origin, triangle, (first + 1) % 3);
  const Vector c = this->See(origin, triangle, (first + 2) % 3);
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const double u = random.Get();
    const double v = i < Corners + Edges ? 0.0 : random.Get() * (1.0 - u);
    beams[i] = Normalize(i < Corners ? a : (1.0 - u - v) * a + u * b + v * c);
  }
  return beams;
}

Tally& Tally::operator+=(const Tally& other)
{
  this->Beams += other.Beams;
  this->Hits += other.Hits;
  this->Misses += other.Misses;
  this->FalseHits += other.FalseHits;
  this->WorstError = std::max(this->WorstError, other.WorstError);
  return *this;
}

std::ostream& operator<<(std::ostream& os, const Tally& tally)
{
  return os << tally.Beams << " beams, " << tally.Hits << " hits, " << tally.Misses << " missed, "
            << tally.FalseHits << " false, worst range off by " << tally.WorstError << " ulp";
}

Tally Judge(const Target& target, const Vector& origin, const Beams& directions)
{
  lms3dBeamPacket packet = Aim(directions);
  target.Caster->Cast({ { origin[0], origin[1], origin[2] }, Infinity }, &packet, 1);
  Tally tally;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    tally += JudgeBeam(target, origin, directions[i], packet.Range[i], packet.Triangle[i]);
  }
  return tally;
}

Tally JudgeEach(std::size_t count, const std::function<Tally(std::size_t)>& judge)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, count), Tally(),
    [&](const tbb::blocked_range<std::size_t>& part, Tally tally)
    {
      for (std::size_t i = part.begin(); i < part.end(); ++i)
      {
        tally += judge(i);
      }
      return tally;
    },
    [](Tally a, const Tally& b) { return a += b; });
}
