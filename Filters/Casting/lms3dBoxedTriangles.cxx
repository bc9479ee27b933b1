// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dBoxedTriangles.h"

#include "Casting/lms3dOutlyingTriangles.h"

namespace
{
// Measured: larger scenes wait for memory, and a test that one box would have spared costs more.
constexpr std::size_t MaximumTriangles = 200000;

// The largest surface of a pair's box, relative to the surfaces of both boxes together.
constexpr float MaximumSurface = 0.75f;

// Half of it.
float GetSurface(const lms3dNormalizedBox& box)
{
  const float x = box.High[0] - box.Low[0];
  const float y = box.High[1] - box.Low[1];
  const float z = box.High[2] - box.Low[2];
  return x * y + y * z + z * x;
}

bool IsPair(const lms3dNormalizedBox& a, const lms3dNormalizedBox& b)
{
  return GetSurface(lms3dJoin(a, b)) <= MaximumSurface * (GetSurface(a) + GetSurface(b));
}
} // namespace

lms3dBoxedTriangles::lms3dBoxedTriangles(const lms3dTriangleMesh& mesh,
  const lms3dNormalization& normalization, const std::vector<std::uint32_t>& excluded)
  : Mesh(mesh)
  , Normalization(normalization)
  , Count(mesh.GetNumberOfTriangles() - excluded.size())
{
  if (!excluded.empty())
  {
    this->Ranges.reserve(this->Count);
    for (std::uint32_t triangle : lms3dFindOtherTriangles(mesh, excluded))
    {
      this->Ranges.push_back(2 * triangle);
    }
  }
  else if (this->Count <= MaximumTriangles)
  {
    this->AddPairs();
    this->Count = this->Ranges.size();
  }
}

void lms3dBoxedTriangles::AddPairs()
{
  const auto end = static_cast<std::uint32_t>(this->Mesh.GetNumberOfTriangles());
  this->Ranges.reserve(end);
  std::uint32_t triangle = 0;
  lms3dNormalizedBox box = this->GetBoxOfTriangle(0);
  for (; triangle + 1 < end; ++triangle)
  {
    lms3dNormalizedBox next = this->GetBoxOfTriangle(triangle + 1);
    const std::uint32_t isPair = IsPair(box, next) ? 1 : 0;
    this->Ranges.push_back(2 * triangle + isPair);
    triangle += isPair;
    box = isPair != 0 && triangle + 1 < end ? this->GetBoxOfTriangle(triangle + 1) : next;
  }
  if (triangle < end)
  {
    this->Ranges.push_back(2 * triangle);
  }
  this->Ranges.shrink_to_fit();
}

lms3dNormalizedBox lms3dBoxedTriangles::GetBox(std::uint32_t box) const
{
  const Range triangles = this->Get(box);
  const lms3dNormalizedBox first = this->GetBoxOfTriangle(triangles.First);
  return triangles.Count == 1 ? first
                              : lms3dJoin(first, this->GetBoxOfTriangle(triangles.First + 1));
}
