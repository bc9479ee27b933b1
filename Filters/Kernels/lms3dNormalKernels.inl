// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums the normals of a map's triangles at their corners, weighted by area.
 */
#ifndef lms3dNormalKernels_inl
#define lms3dNormalKernels_inl

#include "Kernels/lms3dNormalTile.h"

#include <cmath>

namespace
{
using Tile = lms3dNormalTile;

void SetSides(Tile& tile)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Tile::Points; ++i)
    {
      tile.Across[axis][i] = tile.Next[axis][i] - tile.Here[axis][i];
      tile.Here[axis][i] = tile.Next[axis][i];
    }
    for (int i = 0; i < Tile::Cells; ++i)
    {
      tile.HereSide[axis][i] = tile.NextSide[axis][i];
      tile.NextSide[axis][i] = tile.Next[axis][i + 1] - tile.Next[axis][i];
    }
  }
}

void SetWeights(Tile& tile)
{
  for (int i = 0; i < Tile::Cells; ++i)
  {
    tile.Weight[0][i] = tile.Triangles[i] & 1;
    tile.Weight[1][i] = tile.Triangles[i] >> 1 & 1;
    tile.Weight[2][i] = tile.Triangles[i] >> 2 & 1;
    tile.Weight[3][i] = tile.Triangles[i] >> 3 & 1;
  }
}

// The normal of the triangle at corner i of a cell is the cross product of the cell's two sides at that
// corner. Triangles at opposite corners share the other two corners.
template <int Axis>
void AddTriangles(Tile& tile)
{
  constexpr int u = (Axis + 1) % 3;
  constexpr int v = (Axis + 2) % 3;
  const auto& across = tile.Across;
  const auto& here = tile.HereSide;
  const auto& next = tile.NextSide;
  for (int i = 0; i < Tile::Cells; ++i)
  {
    const double n0 = tile.Weight[0][i] * (across[u][i] * here[v][i] - across[v][i] * here[u][i]);
    const double n1 = tile.Weight[1][i] * (across[u][i] * next[v][i] - across[v][i] * next[u][i]);
    const double n2 =
      tile.Weight[2][i] * (across[u][i + 1] * next[v][i] - across[v][i + 1] * next[u][i]);
    const double n3 =
      tile.Weight[3][i] * (across[u][i + 1] * here[v][i] - across[v][i + 1] * here[u][i]);
    const double even = n0 + n2;
    const double odd = n1 + n3;
    tile.HereBegin[Axis][i] = tile.NextBegin[Axis][i] + (odd + n0);
    tile.HereEnd[Axis][i] = tile.NextEnd[Axis][i] + (even + n3);
    tile.NextBegin[Axis][i] = even + n1;
    tile.NextEnd[Axis][i] = odd + n2;
  }
  for (int i = 1; i < Tile::Cells; ++i)
  {
    tile.Sum[Axis][i] = tile.HereBegin[Axis][i] + tile.HereEnd[Axis][i - 1];
  }
}

void SetScales(Tile& tile)
{
  for (int i = 1; i < Tile::Cells; ++i)
  {
    const double x = tile.Sum[0][i];
    const double y = tile.Sum[1][i];
    const double z = tile.Sum[2][i];
    tile.Scale[i] = 1.0 / std::sqrt(x * x + y * y + z * z);
  }
}

void AddStrip(Tile& tile)
{
  SetSides(tile);
  SetWeights(tile);
  AddTriangles<0>(tile);
  AddTriangles<1>(tile);
  AddTriangles<2>(tile);
  SetScales(tile);
}
} // namespace

#endif
