// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dPartHits.h"

#include "Casting/lms3dRayCaster.h"

#include <cmath>

void lms3dPartHits::Allocate(std::size_t rays)
{
  this->Ranges.assign(rays, lms3dBeamPacket::NoRange);
  this->Triangles.assign(rays, lms3dBeamPacket::NoTriangle);
  this->Cells.resize(rays);
}

void lms3dPartHits::ReduceToNearest(const lms3dProcesses& processes, const lms3dRayCaster* caster,
  std::int64_t firstCell, double* ranges, std::int32_t* triangles)
{
  const std::size_t rays = this->Triangles.size();
  const auto getOwnCell = [this, caster, firstCell](std::size_t ray)
  {
    const std::int32_t triangle = this->Triangles[ray];
    return triangle == lms3dBeamPacket::NoTriangle
      ? lms3dProcesses::NoCell
      : firstCell + caster->GetMesh().GetCell(triangle);
  };
  for (std::size_t i = 0; i < rays; ++i)
  {
    this->Cells[i] = getOwnCell(i);
  }
  processes.ReduceToNearest(this->Ranges, this->Cells, ranges);
  for (std::size_t i = 0; i < rays; ++i)
  {
    const bool isReturn = !std::isnan(ranges[i]);
    triangles[i] = isReturn ? 0 : lms3dBeamPacket::NoTriangle;
    if (!isReturn || getOwnCell(i) != this->Cells[i])
    {
      this->Triangles[i] = lms3dBeamPacket::NoTriangle;
    }
  }
  this->Ranges = {};
}
