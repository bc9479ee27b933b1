// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dOffsetStrips.h"

#include <algorithm>

bool lms3dOffsetStrips::AddStrip(
  const std::vector<std::int32_t>& own, const std::vector<std::int32_t>& other)
{
  const std::size_t first = this->Triangles.size();
  for (std::size_t i = 0; i + 1 < own.size(); ++i)
  {
    this->AddQuad(own[i], other[i], other[i + 1], own[i + 1]);
  }
  return std::all_of(this->Triangles.begin() + static_cast<std::ptrdiff_t>(first),
    this->Triangles.end(),
    [&](const Triangle& triangle)
    { return this->IsFacing(triangle[0], triangle[1], triangle[2]); });
}

void lms3dOffsetStrips::FillHole(const std::vector<std::int32_t>& hole)
{
  if (hole.size() == 3)
  {
    this->AddTriangle(hole[0], hole[1], hole[2]);
  }
  else if (hole.size() == 4)
  {
    this->AddQuad(hole[0], hole[1], hole[2], hole[3]);
  }
}

// Splits a counter-clockwise quadrilateral along the diagonal that lets both triangles face the
// sensor.
void lms3dOffsetStrips::AddQuad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d)
{
  if (a == b || c == d || (this->IsFacing(a, b, c) && this->IsFacing(a, c, d)))
  {
    this->AddTriangle(a, b, c);
    this->AddTriangle(a, c, d);
  }
  else
  {
    this->AddTriangle(a, b, d);
    this->AddTriangle(b, c, d);
  }
}

void lms3dOffsetStrips::AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c)
{
  if (a != b && b != c && c != a)
  {
    this->Triangles.push_back({ a, b, c });
  }
}

bool lms3dOffsetStrips::IsFacing(std::int32_t a, std::int32_t b, std::int32_t c) const
{
  return lms3dDot(lms3dCross(this->Vertices[a].Direction, this->Vertices[b].Direction),
           this->Vertices[c].Direction) < 0.0;
}
