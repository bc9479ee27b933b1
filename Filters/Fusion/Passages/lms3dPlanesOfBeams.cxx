// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dPlanesOfBeams.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>

namespace
{
// How many beams of a turn are looked at together.
constexpr int BeamsAtOnce = 16;
} // namespace

lms3dPlanesOfBeams::lms3dPlanesOfBeams(const lms3dLocalMap& local, int beams,
  const std::vector<int>& planeOfPatch, const lms3dFusedPlanes& planes)
  : Planes(static_cast<std::size_t>(beams), -1)
  , Returns(Planes)
{
  tbb::parallel_for(std::size_t{ 0 }, local.Returns.size(),
    [&](std::size_t i)
    {
      const lms3dMappedReturn& mapped = local.Returns[i];
      const int patch = local.PatchIds[mapped.Triangle];
      const int plane = patch < 0 ? -1 : planeOfPatch[patch];
      const bool isOnPlane = plane >= 0 &&
        std::abs(planes[plane].Frame.GetHeight(mapped.Point)) <= planes.GetMaximumError();
      this->Planes[mapped.BeamId] = isOnPlane ? plane : -1;
      this->Returns[mapped.BeamId] = static_cast<int>(i);
    });
}

std::vector<int> lms3dPlanesOfBeams::FindMixed(const Turns& turns, int beams) const
{
  std::vector<int> mixed;
  // The first of the beams that have the plane of the last one in all turns.
  int same = 0;
  for (int last = 0; last < beams; ++last)
  {
    if (!this->HasOnePlane(turns, last))
    {
      same = last + 1;
    }
    else if (this->Planes[turns[0] + last] != this->Planes[turns[0] + same])
    {
      same = last;
    }
    if (last >= 3 && same > last - 3)
    {
      mixed.push_back(last - 3);
    }
    else if (same <= last - 3 && this->HaveOnePlane(turns, last, beams))
    {
      last += BeamsAtOnce;
    }
  }
  return mixed;
}

// Whether the beams of the turns have one plane.
bool lms3dPlanesOfBeams::HasOnePlane(const Turns& turns, int beam) const
{
  const int* const planes = this->Planes.data() + beam;
  const int first = planes[turns[0]];
  return ((planes[turns[1]] ^ first) | (planes[turns[2]] ^ first) | (planes[turns[3]] ^ first)) ==
    0;
}

// Whether the beams of the turns behind one beam, and this beam, have one plane.
bool lms3dPlanesOfBeams::HaveOnePlane(const Turns& turns, int beam, int beams) const
{
  if (beam + BeamsAtOnce >= beams)
  {
    return false;
  }
  const int plane = this->Planes[turns[0] + beam];
  int different = 0;
  for (const int turn : turns)
  {
    const int* const planes = this->Planes.data() + turn + beam;
    for (int i = 1; i <= BeamsAtOnce; ++i)
    {
      different |= planes[i] ^ plane;
    }
  }
  return different == 0;
}
