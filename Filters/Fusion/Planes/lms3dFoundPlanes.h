// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lets the threads find planes for each plane of a map.
 */
#ifndef lms3dFoundPlanes_h
#define lms3dFoundPlanes_h

#include "Fusion/Planes/lms3dFusedPlanes.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

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
