// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums the normals of a map's triangles at their corners, weighted by area.
 */
#ifndef lms3dNormalKernels_inl
#define lms3dNormalKernels_inl

#include "Kernels/lms3dNormalStrip.h"

#include <cmath>

namespace
{
using Strip = lms3dNormalStrip;

void SetSides(Strip& strip)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Strip::Points; ++i)
    {
      strip.Across[axis][i] = strip.Next[axis][i] - strip.Here[axis][i];
      strip.Here[axis][i] = strip.Next[axis][i];
    }
    for (int i = 0; i < Strip::Cells; ++i)
    {
      strip.HereSide[axis][i] = strip.NextSide[axis][i];
      strip.NextSide[axis][i] = strip.Next[axis][i + 1] - strip.Next[axis][i];
    }
  }
}

void SetWeights(Strip& strip)
{
  for (int i = 0; i < Strip::Cells; ++i)
  {
    strip.Weight[0][i] = strip.Triangles[i] & 1;
    strip.Weight[1][i] = strip.Triangles[i] >> 1 & 1;
    strip.Weight[2][i] = strip.Triangles[i] >> 2 & 1;
    strip.Weight[3][i] = strip.Triangles[i] >> 3 & 1;
  }
}

// The normal of the triangle at corner i of a cell is the cross product of the cell's two sides at
// that corner. Triangles at opposite corners share the other two corners.
template <int Axis>
void AddTriangles(Strip& strip)
{
  constexpr int u = (Axis + 1) % 3;
  constexpr int v = (Axis + 2) % 3;
  const auto& across = strip.Across;
  const auto& here = strip.HereSide;
  const auto& next = strip.NextSide;
  for (int i = 0; i < Strip::Cells; ++i)
  {
    const double n0 = strip.Weight[0][i] * (across[u][i] * here[v][i] - across[v][i] * here[u][i]);
    const double n1 = strip.Weight[1][i] * (across[u][i] * next[v][i] - across[v][i] * next[u][i]);
    const double n2 =
      strip.Weight[2][i] * (across[u][i + 1] * next[v][i] - across[v][i + 1] * next[u][i]);
    const double n3 =
      strip.Weight[3][i] * (across[u][i + 1] * here[v][i] - across[v][i + 1] * here[u][i]);
    const double even = n0 + n2;
    const double odd = n1 + n3;
    strip.HereBegin[Axis][i] = strip.NextBegin[Axis][i] + (odd + n0);
    strip.HereEnd[Axis][i] = strip.NextEnd[Axis][i] + (even + n3);
    strip.NextBegin[Axis][i] = even + n1;
    strip.NextEnd[Axis][i] = odd + n2;
  }
  for (int i = 1; i < Strip::Cells; ++i)
  {
    strip.Sum[Axis][i] = strip.HereBegin[Axis][i] + strip.HereEnd[Axis][i - 1];
  }
}

void SetScales(Strip& strip)
{
  for (int i = 1; i < Strip::Cells; ++i)
  {
    const double x = strip.Sum[0][i];
    const double y = strip.Sum[1][i];
    const double z = strip.Sum[2][i];
    strip.Scale[i] = 1.0 / std::sqrt(x * x + y * y + z * z);
  }
}

void AddStrip(Strip& strip)
{
  SetSides(strip);
  SetWeights(strip);
  AddTriangles<0>(strip);
  AddTriangles<1>(strip);
  AddTriangles<2>(strip);
  SetScales(strip);
}
} // namespace

#endif
