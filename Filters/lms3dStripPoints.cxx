// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStripPoints.h"

#include <algorithm>
#include <cstddef>

lms3dStripPoints::lms3dStripPoints(const lms3dRangeGrid& grid, const double* points, int firstTurn)
  : Grid(grid)
  , Points(points)
{
  for (Turn* turn : { &this->Here, &this->Next })
  {
    for (std::vector<double>& coordinates : *turn)
    {
      coordinates.resize(grid.GetNumberOfBeams());
    }
  }
  this->Fetch(firstTurn, this->Next);
}

void lms3dStripPoints::MoveTo(int turn)
{
  std::swap(this->Here, this->Next);
  this->Fetch(turn + 1, this->Next);
}

void lms3dStripPoints::Fetch(int turn, Turn& out) const
{
  const std::int32_t* vertices = this->Grid.GetVertices(turn);
  double* x = out[0].data();
  double* y = out[1].data();
  double* z = out[2].data();
  for (int i = 0; i < this->Grid.GetNumberOfBeams(); ++i)
  {
    const double* point = this->Points + 3 * static_cast<std::ptrdiff_t>(std::max(vertices[i], 0));
    x[i] = point[0];
    y[i] = point[1];
    z[i] = point[2];
  }
}

void lms3dStripPoints::FindShorterDiagonals(int cells, std::uint8_t* areShorter) const
{
  const double* hx = this->Here[0].data();
  const double* hy = this->Here[1].data();
  const double* hz = this->Here[2].data();
  const double* nx = this->Next[0].data();
  const double* ny = this->Next[1].data();
  const double* nz = this->Next[2].data();
  const auto square = [](double x) { return x * x; };
  for (int i = 0; i < cells; ++i)
  {
    const double even =
      square(hx[i] - nx[i + 1]) + square(hy[i] - ny[i + 1]) + square(hz[i] - nz[i + 1]);
    const double odd =
      square(nx[i] - hx[i + 1]) + square(ny[i] - hy[i + 1]) + square(nz[i] - hz[i + 1]);
    areShorter[i] = even <= odd;
  }
}
