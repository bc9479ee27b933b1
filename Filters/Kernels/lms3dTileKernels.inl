// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels that decide on sixteen tiles at once what a triangle does to them.
 *
 * lms3dTile.h and lms3dNarrowTriangle.h derive the bounds.
 */
#ifndef lms3dTileKernels_inl
#define lms3dTileKernels_inl

#include "Kernels/lms3dNarrowKernels.inl"
#include "Kernels/lms3dPacketMask.inl"

namespace
{
// The bound of a product of a tile's side and a corner of a triangle: 134 u, where u = 6e-8 is one
// rounding. The numbers below are lengths of error vectors.
//
// Corner of a tile, 8 u: the cosine, the fan's axis and their product (3), the sine, its product
// with the half cosine, the upward axis and the last product (4), and the sum (1). lms3dTileGrid
// has a margin for the rounding of the half cosine. Side, 18.5 u: its two corners (16), and the
// products (1.5) and the difference (1) of the cross product. In each component these are 18 u.
// Product with a triangle's corner, whose 1-norm is 1, 22 u: the side (18), the rounding of the
// triangle's corner (1), the products (1) and the sums (2).
//
// If a tile is very thin, rounding can turn a side outwards. The product of the side and `inside`,
// the sum of the two other corners, then is at most 18.5 l + 24 u, where l is the length of
// `inside`: the side's error times l, twice a corner's error and the sum (18), and the roundings of
// the product (6). The same holds for the sum of the products with these two corners. A direction
// in the tile is a sum of corners.
// - Side at the first or last turn: the two other corners are an angle s apart, l is 2 cos(s / 2),
//   and no factor exceeds 1 / l. So a direction lies at most 18.5 + 24 / l u outside: 86 u if l is
//   at least 0.36.
// - Side at the first or last beam: both other corners have the same product, at most 30.5 u. Their
//   factors together are at most 1.42 / sin(s), where s is the angle between the middles of this
//   side and of the opposite one, since the tile's turns span up to 90 degrees: 87 u if s is at
//   most 150 degrees.
// Altogether 109 u. A side for which l or s is beyond these limits is 0 and separates nothing.
constexpr float SideError = 4.0f * lms3dNarrowError;

// The square of the least length l above, and of the cosine of 150 degrees.
constexpr float MinimumInside = 0.13f;
constexpr float MaximumOpposite = 0.75f;

using TileVector = float[3][Size];

// `turn` and `beam` are 0 at the tiles' first turn or beam and 1 at the last. The corner does not
// overlap its input, so that the compiler can vectorize the loop.
void FillTileCorner(const lms3dTiles& tiles, int turn, int beam, TileVector& __restrict corner)
{
  for (int i = 0; i < Size; ++i)
  {
    const float cosine = tiles.Cosine[beam][i];
    const float sine = tiles.Sine[beam][i];
    corner[0][i] = cosine * tiles.Fan[turn][0][i] + sine * tiles.Up[0];
    corner[1][i] = cosine * tiles.Fan[turn][1][i] + sine * tiles.Up[1];
    corner[2][i] = cosine * tiles.Fan[turn][2][i] + sine * tiles.Up[2];
  }
}

// Returns the factor that turns a side inwards, or 0 for a side that rounding may turn. `along` is
// the sum of the side's corners, `inside` that of the two others.
float GetSign(const float (&along)[3], const float (&inside)[3], float product)
{
  const float facing = along[0] * inside[0] + along[1] * inside[1] + along[2] * inside[2];
  const float length = inside[0] * inside[0] + inside[1] * inside[1] + inside[2] * inside[2];
  const float width = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
  const bool isOpposite = (facing < 0.0f) & (facing * facing > MaximumOpposite * length * width);
  const float sign = product < 0.0f ? -1.0f : 1.0f;
  return (length < MinimumInside) | isOpposite ? 0.0f : sign;
}

// `others` is the sum of the two other corners.
void FillTileSide(
  const TileVector& p, const TileVector& q, const TileVector& others, TileVector& side)
{
  for (int i = 0; i < Size; ++i)
  {
    const float x = p[1][i] * q[2][i] - p[2][i] * q[1][i];
    const float y = p[2][i] * q[0][i] - p[0][i] * q[2][i];
    const float z = p[0][i] * q[1][i] - p[1][i] * q[0][i];
    const float inside[3] = { others[0][i], others[1][i], others[2][i] };
    const float along[3] = { p[0][i] + q[0][i], p[1][i] + q[1][i], p[2][i] + q[2][i] };
    const float sign = GetSign(along, inside, x * inside[0] + y * inside[1] + z * inside[2]);
    side[0][i] = sign * x;
    side[1][i] = sign * y;
    side[2][i] = sign * z;
  }
}

void FillTileCorners(lms3dTiles& tiles)
{
  FillTileCorner(tiles, 0, 0, tiles.Corner[0]);
  FillTileCorner(tiles, 1, 0, tiles.Corner[1]);
  FillTileCorner(tiles, 1, 1, tiles.Corner[2]);
  FillTileCorner(tiles, 0, 1, tiles.Corner[3]);
  alignas(64) TileVector inside;
  for (int side = 0; side < 4; ++side)
  {
    const TileVector& third = tiles.Corner[(side + 2) % 4];
    const TileVector& fourth = tiles.Corner[(side + 3) % 4];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < Size; ++i)
      {
        inside[axis][i] = third[axis][i] + fourth[axis][i];
      }
    }
    FillTileSide(tiles.Corner[side], tiles.Corner[(side + 1) % 4], inside, tiles.Side[side]);
  }
}

// Finds the tiles that an edge separates from the triangle, and those inside all three edges.
void CompareWithEdges(
  const lms3dTiles& tiles, const lms3dNarrowTriangle& triangle, Mask& outside, Mask& covered)
{
  for (int i = 0; i < Size; ++i)
  {
    float minimum = 1.0f;
    float minimumOfMaxima = 1.0f;
#pragma GCC unroll 4
    for (int edge = 0; edge < lms3dNarrowTriangle::Plane; ++edge)
    {
      const float a = NarrowDot(tiles.Corner[0], i, triangle, edge);
      const float b = NarrowDot(tiles.Corner[1], i, triangle, edge);
      const float c = NarrowDot(tiles.Corner[2], i, triangle, edge);
      const float d = NarrowDot(tiles.Corner[3], i, triangle, edge);
      minimum = Minimum(minimum, Minimum(Minimum(a, b), Minimum(c, d)));
      minimumOfMaxima = Minimum(minimumOfMaxima, Maximum(Maximum(a, b), Maximum(c, d)));
    }
    outside.Set(i, minimumOfMaxima < -lms3dNarrowError);
    covered.Set(i, minimum > lms3dNarrowError);
  }
}

// Returns the tiles with a side that separates them from the triangle.
std::uint32_t FindSeparated(const lms3dTiles& tiles, const lms3dCornerDirections& corners)
{
  Mask separated;
  for (int i = 0; i < Size; ++i)
  {
    float minimumOfMaxima = 1.0f;
#pragma GCC unroll 4
    for (const TileVector& side : tiles.Side)
    {
      const float a = NarrowDot(side, i, corners.Corner[0]);
      const float b = NarrowDot(side, i, corners.Corner[1]);
      const float c = NarrowDot(side, i, corners.Corner[2]);
      minimumOfMaxima = Minimum(minimumOfMaxima, Maximum(Maximum(a, b), c));
    }
    separated.Set(i, minimumOfMaxima < -SideError);
  }
  return separated.GetBits();
}

// Compares the triangle's plane with the present cover, at all four corners.
lms3dTileMasks CompareWithCover(const lms3dTiles& tiles, const lms3dNarrowTriangle& triangle,
  float minimumInverse, lms3dTileMasks masks, lms3dTileCover& cover)
{
  const float error = triangle.PlaneError;
  const float within = minimumInverse + error;
  alignas(64) float inverse[4][Size];
  Mask behind;
  Mask nearest;
  Mask isWithin;
  for (int i = 0; i < Size; ++i)
  {
    const float margin = cover.Error[i] + error;
    float minimum = MaximumPlane;
    float minimumGain = MaximumPlane;
    float maximumGain = -MaximumPlane;
#pragma GCC unroll 4
    for (int c = 0; c < 4; ++c)
    {
      inverse[c][i] = NarrowDot(tiles.Corner[c], i, triangle, lms3dNarrowTriangle::Plane);
      const float gain = inverse[c][i] - cover.InverseRange[c][i];
      minimum = Minimum(minimum, inverse[c][i]);
      minimumGain = Minimum(minimumGain, gain);
      maximumGain = Maximum(maximumGain, gain);
    }
    behind.Set(i, maximumGain < -margin);
    nearest.Set(i, minimumGain > margin);
    isWithin.Set(i, minimum > within);
  }
  masks.Met &= ~behind.GetBits();
  masks.Covered &= masks.Met & isWithin.GetBits();
  masks.Nearest = masks.Covered & nearest.GetBits();
  if (masks.Nearest == 0)
  {
    return masks;
  }
  for (int i = 0; i < Size; ++i)
  {
    const bool isNearest = (masks.Nearest >> i) & 1u;
    for (int c = 0; c < 4; ++c)
    {
      cover.InverseRange[c][i] = isNearest ? inverse[c][i] : cover.InverseRange[c][i];
    }
    cover.Error[i] = isNearest ? error : cover.Error[i];
  }
  return masks;
}

// GCC would return masks by writing them to memory one by one and loading two at once, for which
// the processor has to wait.
void ClassifyTiles(const lms3dTiles& tiles, const lms3dNarrowTriangle& triangle,
  const lms3dCornerDirections& corners, float minimumInverse, lms3dTileMasks& result,
  lms3dTileCover& cover)
{
  lms3dTileMasks masks = result;
  const bool isNarrow = triangle.PlaneError >= 0.0f;
  if (masks.Covered != masks.Met)
  {
    // The sides first: they alone exclude most triangles of a scene from all of sixteen blocks.
    masks.Met &= ~FindSeparated(tiles, corners);
    if (isNarrow && masks.Met != 0)
    {
      Mask outside;
      Mask covered;
      CompareWithEdges(tiles, triangle, outside, covered);
      masks.Met &= ~outside.GetBits();
      masks.Covered = masks.Met & covered.GetBits();
    }
  }
  if (isNarrow && masks.Met != 0)
  {
    masks = CompareWithCover(tiles, triangle, minimumInverse, masks, cover);
  }
  result = masks;
}
} // namespace

#endif
