// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dNormalization.h"

#include <algorithm>
#include <cmath>

namespace
{
// Rays start no farther from the scene's centre than this, in diagonals.
constexpr double FarthestStart = 2.0;
} // namespace

lms3dNormalization::lms3dNormalization(const lms3dTriangleMesh& mesh)
{
  std::array<double, 3> low = mesh.Points[mesh.Triangles[0][0]];
  std::array<double, 3> high = low;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
  {
    for (std::uint32_t corner : triangle)
    {
      for (int i = 0; i < 3; ++i)
      {
        low[i] = std::min(low[i], mesh.Points[corner][i]);
        high[i] = std::max(high[i], mesh.Points[corner][i]);
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = 0.5 * low[i] + 0.5 * high[i];
  }
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  this->Diagonal = diagonal > 0.0 ? diagonal : 1.0;
}

double lms3dNormalization::GetHeadStart(const double origin[3]) const
{
  const double distance = std::hypot(
    origin[0] - this->Center[0], origin[1] - this->Center[1], origin[2] - this->Center[2]);
  return std::max(0.0, distance - FarthestStart * this->Diagonal);
}
