// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boxes of some blocks of a plane, and the planes near them.
 */
#ifndef lms3dBlockBoxes_h
#define lms3dBlockBoxes_h

#include "Fusion/lms3dFusedPlanes.h"
#include "Fusion/lms3dWorldBox.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

/// Blocks that lie side by side are searched for at once.
class lms3dBlockBoxes
{
public:
  /// Adds a block of a plane, by its number.
  void Add(const lms3dFusedPlane& plane, int number)
  {
    const lms3dRasterBlock& block = plane.Raster.GetBlock(number);
    this->Squares[{ block.U >> 3, block.V >> 3 }].push_back(plane.GetBoxOfBlock(number));
  }

  /// Adds the numbers of planes to `found` whose boxes are nearer to a block than a distance,
  /// metres, along each axis, if `isWanted` says so. A plane may be found several times.
  template <typename Predicate>
  void FindPlanesNear(const lms3dFusedPlanes& planes, double distance, const Predicate& isWanted,
    std::vector<int>& found) const
  {
    for (const auto& [square, boxes] : this->Squares)
    {
      lms3dWorldBox all;
      for (const lms3dWorldBox& box : boxes)
      {
        all.Add(box);
      }
      for (const int number : planes.FindPlanesNear(all, distance))
      {
        const lms3dWorldBox& near = planes.GetBox(number);
        if (isWanted(planes[number]) &&
          std::any_of(boxes.begin(), boxes.end(),
            [&](const lms3dWorldBox& box) { return box.IsNear(near, distance); }))
        {
          found.push_back(number);
        }
      }
    }
  }

private:
  /// By the square of 8 x 8 blocks in which they lie.
  std::map<std::array<std::int32_t, 2>, std::vector<lms3dWorldBox>> Squares;
};

/// Calls `find` with the number of each plane and a list of numbers, to which it adds some. Returns
/// all that it added, in order, each once. The threads divide planes.
template <typename Visitor>
std::vector<int> lms3dFindForPlanes(const lms3dFusedPlanes& planes, const Visitor& find)
{
  tbb::combinable<std::vector<int>> lists;
  tbb::parallel_for(
    std::size_t{ 0 }, planes.GetSize(), [&](std::size_t number) { find(number, lists.local()); });
  std::vector<int> found;
  lists.combine_each(
    [&](const std::vector<int>& list) { found.insert(found.end(), list.begin(), list.end()); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

#endif
