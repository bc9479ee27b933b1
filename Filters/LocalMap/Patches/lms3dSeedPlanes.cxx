// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dSeedPlanes.h"

#include <algorithm>
#include <array>

std::optional<lms3dPlane> lms3dSeedPlanes::FitWindow(int column, int row, int stride) const
{
  const int columns = this->Sphere.GetNumberOfColumns();
  const int half = stride / 2;
  const int step = std::max(1, half / 2);
  std::array<GridIndex, 25> samples;
  int count = 0;
  lms3dPlaneFit fit;
  for (int i = -half; i <= half; i += step)
  {
    for (int j = -half; j <= half; j += step)
    {
      const GridIndex index = this->Sphere.GetIndex((column + i + columns) % columns, row + j);
      if (!this->IsFree(index))
      {
        return std::nullopt;
      }
      fit.Add(this->Sphere, index);
      samples[count++] = index;
    }
  }
  const lms3dPlane plane = fit.GetPlane();
  const bool fits = std::all_of(samples.begin(), samples.begin() + count,
    [&](GridIndex index)
    {
      return lms3dIsWithinTolerance(this->Sphere.GetRange(index),
        plane.GetInverseRange(this->Sphere.GetDirection(index)), this->Tolerance);
    });
  return fits ? std::optional<lms3dPlane>(plane) : std::nullopt;
}

bool lms3dSeedPlanes::IsFreeNeighbor(GridIndex seed, int side) const
{
  return !this->Sphere.IsPoleRow(this->Sphere.GetRow(seed)) &&
    this->Sphere.HasNeighbor(seed, side) && this->Sphere.IsJoined(seed, side) &&
    this->IsFree(this->Sphere.GetNeighbor(seed, side));
}

lms3dPlane lms3dSeedPlanes::FitNeighbors(GridIndex seed) const
{
  lms3dPlaneFit fit;
  fit.Add(this->Sphere, seed);
  for (int first : { lms3dBeamSphere::Up, lms3dBeamSphere::Down })
  {
    for (int second : { lms3dBeamSphere::Right, lms3dBeamSphere::Left })
    {
      if (this->IsFreeNeighbor(seed, first) && this->IsFreeNeighbor(seed, second))
      {
        fit.Add(this->Sphere, this->Sphere.GetNeighbor(seed, first));
        fit.Add(this->Sphere, this->Sphere.GetNeighbor(seed, second));
        return fit.GetPlane();
      }
    }
  }
  for (int side :
    { lms3dBeamSphere::Up, lms3dBeamSphere::Right, lms3dBeamSphere::Down, lms3dBeamSphere::Left })
  {
    if (this->IsFreeNeighbor(seed, side))
    {
      fit.Add(this->Sphere, this->Sphere.GetNeighbor(seed, side));
      return fit.GetPlane();
    }
  }
  return fit.GetPlane();
}
