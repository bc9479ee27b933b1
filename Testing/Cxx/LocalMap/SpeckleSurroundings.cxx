// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/SpeckleSurroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;
constexpr int BeamsNear = 9;
} // namespace

vtkIdType GetReturnOf(const MapCase& map, const Beam& beam)
{
  return map.Grid.Contains(beam) ? map.Grid.GetReturn(beam) : ScanGrid::NoReturn;
}

SpeckleSurroundings::SpeckleSurroundings(const MapCase& map, const Beam& first)
  : Map(map)
{
  this->Find(first);
  this->FitPlane();
}

void SpeckleSurroundings::Find(const Beam& first)
{
  std::set<vtkIdType> members = { this->Map.Grid.GetReturn(first) };
  std::vector<Beam> waiting = { first };
  while (!waiting.empty())
  {
    const Beam beam = waiting.back();
    waiting.pop_back();
    int near = 0;
    ForEachReturnNear(this->Map, beam,
      [&](const Beam& next, vtkIdType number)
      {
        ++near;
        if (!this->Map.IsSpeckle(next))
        {
          this->Returns.insert(number);
        }
        else if (members.insert(number).second)
        {
          waiting.push_back(next);
        }
      });
    this->IsWhole = this->IsWhole && near == BeamsNear;
  }
}

// On a plane, the inverse range is linear in the direction: the normal equations give the plane.
void SpeckleSurroundings::FitPlane()
{
  std::array<Vector, 3> matrix = {};
  Vector right = {};
  for (vtkIdType number : this->Returns)
  {
    const Vector direction = Normalize(this->Map.Grid.GetPoints()[number]);
    const double inverse = 1.0 / GetLength(this->Map.Grid.GetPoints()[number]);
    for (int i = 0; i < 3; ++i)
    {
      matrix[i] = matrix[i] + direction[i] * direction;
      right[i] += inverse * direction[i];
    }
  }
  const auto& [p, q, r] = matrix;
  const double determinant = Dot(p, Cross(q, r));
  this->Plane = { Dot(right, Cross(q, r)) / determinant, Dot(p, Cross(right, r)) / determinant,
    Dot(p, Cross(q, right)) / determinant };
}

bool SpeckleSurroundings::AreOnOnePlane(double tolerance) const
{
  return std::all_of(this->Returns.begin(), this->Returns.end(),
    [&](vtkIdType number)
    {
      const Vector& point = this->Map.Grid.GetPoints()[number];
      return std::abs(this->GetRange(Normalize(point)) - GetLength(point)) <= tolerance;
    });
}
