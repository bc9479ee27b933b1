// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boxes of some blocks of a plane, and the planes near them.
 */
#ifndef lms3dBlockBoxes_h
#define lms3dBlockBoxes_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dWorldBox.h"

#include <algorithm>
#include <array>
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

#endif
