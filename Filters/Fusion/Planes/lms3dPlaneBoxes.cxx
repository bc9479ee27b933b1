// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dPlaneBoxes.h"

#include <algorithm>
#include <cmath>

namespace
{
// A plane that meets more cubes is large.
constexpr double LargestCount = 64.0;
// A search in more cubes looks at all planes instead.
constexpr double LargestSearch = 512.0;
// Cubes: no cube lies farther away.
constexpr double LargestCube = 1e15;
} // namespace

double lms3dPlaneBoxes::Cubes::Count() const
{
  double count = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    count *=
      static_cast<double>(std::max<std::int64_t>(this->Last[axis] - this->First[axis] + 1, 0));
  }
  return count;
}

bool lms3dPlaneBoxes::Cubes::Has(const Cube& cube) const
{
  bool isIn = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    isIn = isIn && this->First[axis] <= cube[axis] && cube[axis] <= this->Last[axis];
  }
  return isIn;
}

lms3dPlaneBoxes::Cubes lms3dPlaneBoxes::GetCubes(const lms3dWorldBox& box, double margin) const
{
  Cubes cubes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto find = [this](double place)
    {
      return static_cast<std::int64_t>(
        std::clamp(std::floor(place / this->Size), -LargestCube, LargestCube));
    };
    cubes.First[axis] = find(box.Low[axis] - margin);
    cubes.Last[axis] = find(box.High[axis] + margin);
  }
  return cubes;
}

// Cubes that are far apart may share a key, which adds planes to a search alone.
std::uint64_t lms3dPlaneBoxes::GetKey(const Cube& cube)
{
  std::uint64_t key = 0;
  for (const std::int64_t place : cube)
  {
    key = key << 21U | (static_cast<std::uint64_t>(place) & 0x1fffffU);
  }
  return key;
}

template <typename Visitor>
void lms3dPlaneBoxes::ForCubes(const Cubes& cubes, const Visitor& visit)
{
  Cube cube = {};
  for (cube[0] = cubes.First[0]; cube[0] <= cubes.Last[0]; ++cube[0])
  {
    for (cube[1] = cubes.First[1]; cube[1] <= cubes.Last[1]; ++cube[1])
    {
      for (cube[2] = cubes.First[2]; cube[2] <= cubes.Last[2]; ++cube[2])
      {
        visit(cube);
      }
    }
  }
}

void lms3dPlaneBoxes::Grow(std::size_t plane, const lms3dVector& point)
{
  Plane& grown = this->Planes[plane];
  grown.Box.Add(point);
  if (grown.IsLarge)
  {
    return;
  }
  const Cubes cubes = this->GetCubes(grown.Box, 0.0);
  if (cubes.First == grown.Listed.First && cubes.Last == grown.Listed.Last)
  {
    return;
  }
  const auto number = static_cast<int>(plane);
  grown.IsLarge = cubes.Count() > LargestCount;
  if (grown.IsLarge)
  {
    this->Large.push_back(number);
    return;
  }
  ForCubes(cubes,
    [&](const Cube& cube)
    {
      if (!grown.Listed.Has(cube))
      {
        this->InCube[GetKey(cube)].push_back(number);
      }
    });
  grown.Listed = cubes;
}

void lms3dPlaneBoxes::Remove(std::size_t plane)
{
  const auto take = [number = static_cast<int>(plane)](std::vector<int>& list)
  { list.erase(std::remove(list.begin(), list.end(), number), list.end()); };
  Plane& removed = this->Planes[plane];
  if (removed.IsLarge)
  {
    take(this->Large);
  }
  ForCubes(removed.Listed,
    [&](const Cube& cube)
    {
      const auto place = this->InCube.find(GetKey(cube));
      if (place != this->InCube.end())
      {
        take(place->second);
        if (place->second.empty())
        {
          this->InCube.erase(place);
        }
      }
    });
  removed = {};
}

std::vector<int> lms3dPlaneBoxes::Find(
  const lms3dWorldBox& box, double distance, std::size_t end) const
{
  std::vector<int> found;
  const auto add = [&](int plane)
  {
    if (static_cast<std::size_t>(plane) < end && box.IsNear(this->Planes[plane].Box, distance))
    {
      found.push_back(plane);
    }
  };
  // Twice the distance is more than the distance and rounding.
  const Cubes cubes = this->GetCubes(box, 2.0 * distance);
  if (cubes.Count() > LargestSearch)
  {
    for (std::size_t plane = 0; plane < end; ++plane)
    {
      add(static_cast<int>(plane));
    }
    return found;
  }
  std::for_each(this->Large.begin(), this->Large.end(), add);
  ForCubes(cubes,
    [&](const Cube& cube)
    {
      const auto place = this->InCube.find(GetKey(cube));
      if (place != this->InCube.end())
      {
        std::for_each(place->second.begin(), place->second.end(), add);
      }
    });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}
