// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dCoveringPlanes.h"

#include <algorithm>
#include <cmath>

namespace
{
// Bounds: half of the size of a box.
constexpr double Reach = 5.0;
} // namespace

void lms3dCoveringPlanes::FindNear(const lms3dVector& point)
{
  if (this->Box.IsNear(point, 0.0))
  {
    return;
  }
  const double reach = Reach * this->Planes.GetMaximumError();
  this->Box = {};
  this->Box.Add(lms3dAdd(point, { reach, reach, reach }));
  this->Box.Add(lms3dSubtract(point, { reach, reach, reach }));
  this->Near = this->Planes.FindPlanesNear(this->Box, this->Planes.GetMaximumError());
}

bool lms3dCoveringPlanes::Covers(int number, const lms3dMappedReturn& mapped, double distance) const
{
  const lms3dFusedPlane& plane = this->Planes[number];
  return std::abs(plane.Frame.GetHeight(mapped.Point)) <= distance &&
    this->Planes.GetBox(number).IsNear(mapped.Point, this->Planes.GetMaximumError()) &&
    this->Planes.Covers(plane, mapped);
}

int lms3dCoveringPlanes::Find(
  const lms3dMappedReturn& mapped, const std::vector<int>& exceptions, double distance)
{
  this->FindNear(mapped.Point);
  int beside = -1;
  for (const int number : this->Near)
  {
    if (std::find(exceptions.begin(), exceptions.end(), number) != exceptions.end() ||
      !this->Covers(number, mapped, distance))
    {
      continue;
    }
    const lms3dFusedPlane& plane = this->Planes[number];
    if (this->Planes.IsMetBy(plane, mapped))
    {
      return number;
    }
    // Single triangles and facets never grow to the beam.
    beside = beside < 0 && plane.Verbatim.empty() ? number : beside;
  }
  return beside;
}
