// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dStepBands.h"

#include <algorithm>

bool lms3dStepBands::AddBand(
  const std::vector<std::int32_t>& own, const std::vector<std::int32_t>& other)
{
  const std::size_t first = this->Triangles.size();
  for (std::size_t i = 0; i + 1 < own.size(); ++i)
  {
    this->AddQuad(own[i], other[i], other[i + 1], own[i + 1]);
  }
  return std::all_of(this->Triangles.begin() + static_cast<std::ptrdiff_t>(first),
    this->Triangles.end(),
    [&](const std::array<std::int32_t, 3>& triangle)
    { return this->IsFacing(triangle[0], triangle[1], triangle[2]); });
}

void lms3dStepBands::FillRing(const std::vector<std::int32_t>& ring)
{
  if (ring.size() == 3)
  {
    this->AddTriangle(ring[0], ring[1], ring[2]);
  }
  else if (ring.size() == 4)
  {
    this->AddQuad(ring[0], ring[1], ring[2], ring[3]);
  }
}

// Counter-clockwise, cut along the diagonal that leaves both triangles facing the sensor.
void lms3dStepBands::AddQuad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d)
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

void lms3dStepBands::AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c)
{
  if (a != b && b != c && c != a)
  {
    this->Triangles.push_back({ a, b, c });
  }
}

bool lms3dStepBands::IsFacing(std::int32_t a, std::int32_t b, std::int32_t c) const
{
  return lms3dDot(lms3dCross(this->Vertices[a].Direction, this->Vertices[b].Direction),
           this->Vertices[c].Direction) < 0.0;
}
