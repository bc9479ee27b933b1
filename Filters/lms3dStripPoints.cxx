// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStripPoints.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

lms3dStripPoints::lms3dStripPoints(const lms3dRangeGrid& grid, const double* points, int firstBeam)
  : Grid(grid)
  , Points(points)
  , FirstBeam(firstBeam)
  , Beams(std::min(MostBeams, grid.GetNumberOfBeams() + 1 - firstBeam))
{
}

void lms3dStripPoints::Fetch(int turn)
{
  this->Here = this->Next;
  const std::int32_t* vertices = this->Grid.GetVertices(turn) + this->FirstBeam;
  for (int i = 0; i < this->Beams; ++i)
  {
    const double* point = this->Points + 3 * static_cast<std::ptrdiff_t>(std::max(vertices[i], 0));
    this->Next[0][i] = point[0];
    this->Next[1][i] = point[1];
    this->Next[2][i] = point[2];
  }
}
