// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/TileFixtures.h"

#include "Casting/lms3dTileGrid.h"
#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
// The direction at two angles, degrees, of a sensor that is not upright.
Vector MakeDirection(double alpha, double beta)
{
  const double a = alpha * lms3dRadiansPerDegree;
  const double b = beta * lms3dRadiansPerDegree;
  return Turn(Turn({ std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b), std::sin(a) }));
}
} // namespace

Tile Tile::Make(Random& random)
{
  const double sides[] = { 0.0, 0.25, 1.5, 7.5, 31.0, 90.0 };
  Tile tile;
  tile.Alpha[0] = random.GetBits() % 8 == 0 ? -90.0 : random.Get(-90.0, 89.0);
  tile.Alpha[1] = std::min(90.0, tile.Alpha[0] + sides[random.GetBits() % 6]);
  tile.Beta[0] = random.Get(0.0, 360.0);
  tile.Beta[1] = tile.Beta[0] + sides[random.GetBits() % 6];
  tile.Level = random.GetBits() % 3;
  return tile;
}

Tile Tile::MakeNearlyFromPoleToPole(Random& random)
{
  const double alpha = 90.0 - std::pow(10.0, random.Get(-3.0, -1.0));
  const double beta = random.Get(0.0, 360.0);
  return { { -alpha, alpha }, { beta, beta + std::pow(10.0, random.Get(-1.0, 1.5)) }, 0 };
}

Tile Tile::MakeWide(Random& random)
{
  const double alpha = random.Get(45.0, 89.5);
  const double beta = random.Get(0.0, 360.0);
  return { { -alpha, alpha }, { beta, beta + std::pow(10.0, random.Get(-5.0, 1.95)) }, 0 };
}

Tile Tile::MakeThin(Random& random)
{
  const double alpha = random.Get(79.0, 79.6);
  const double beta = random.Get(0.0, 360.0);
  return { { -alpha, alpha }, { beta, beta + std::pow(10.0, random.Get(-5.5, -3.5)) }, 2 };
}

Tile Tile::MakeSmall(Random& random)
{
  const double alpha = random.Get(-80.0, 70.0);
  const double beta = random.Get(0.0, 360.0);
  return { { alpha, alpha + random.Get(0.25, 7.5) }, { beta, beta + random.Get(0.25, 7.5) }, 2 };
}

Vector Tile::GetDirection(double alphaShare, double betaShare) const
{
  return MakeDirection(this->Alpha[0] + alphaShare * (this->Alpha[1] - this->Alpha[0]),
    this->Beta[0] + betaShare * (this->Beta[1] - this->Beta[0]));
}

Vector Tile::GetDirection(Random& random) const
{
  double share[2];
  for (double& s : share)
  {
    const std::uint64_t kind = random.GetBits() % 4;
    s = kind < 2 ? static_cast<double>(kind) : random.Get();
  }
  return this->GetDirection(share[0], share[1]);
}

void Tile::Fill(lms3dTiles& tiles) const
{
  const lms3dTileGrid::Area area = { this->Level, 0, 0 };
  const int side = area.GetSide();
  std::vector<Vector> fanAxes(side);
  std::vector<double> cosines(side);
  std::vector<double> sines(side);
  const double alphaStep = (this->Alpha[1] - this->Alpha[0]) / (side - 1);
  const double betaStep = (this->Beta[1] - this->Beta[0]) / (side - 1);
  for (int i = 0; i < side; ++i)
  {
    // The last angles without rounding.
    const double alpha = i == side - 1 ? this->Alpha[1] : this->Alpha[0] + i * alphaStep;
    cosines[i] = std::cos(alpha * lms3dRadiansPerDegree);
    sines[i] = std::sin(alpha * lms3dRadiansPerDegree);
    fanAxes[i] = MakeDirection(0.0, i == side - 1 ? this->Beta[1] : this->Beta[0] + i * betaStep);
  }
  const Vector up = Turn(Turn({ 0.0, 0.0, 1.0 }));
  const lms3dTileGrid grid(
    { side, side, fanAxes.data(), betaStep, cosines.data(), sines.data(), up });
  for (int i = 0; i < lms3dTiles::Size; ++i)
  {
    grid.FillTile(area, i, tiles);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    tiles.Up[axis] = static_cast<float>(up[axis]);
  }
  lms3dGetPacketKernels().FillTileCorners(tiles);
}

lms3dTileMasks ClassifyTile(
  const lms3dTiles& tiles, const SeenTriangle& triangle, double maximumRange, lms3dTileCover& cover)
{
  const lms3dPacketKernels& kernels = lms3dGetPacketKernels();
  const lms3dSensorFrameTriangle corners = triangle.GetInSensorFrame();
  const float minimumInverse = std::nextafter(static_cast<float>(1.0 / maximumRange), 1e30f);
  lms3dTileMasks masks = { 1u, 0u, 0u };
  kernels.ClassifyTiles(tiles, kernels.MakeNarrowTriangle(corners, 1.0),
    lms3dGetCornerDirections(corners), minimumInverse, masks, cover);
  return masks;
}
