// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What one of several processes finds in its part of the scene, and the nearest hits of all.
 */
#ifndef lms3dPartHits_h
#define lms3dPartHits_h

#include "Scan/lms3dPacketGrid.h"
#include "Scan/lms3dProcesses.h"

#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dRayCaster;

/// One value for each ray.
class lms3dPartHits
{
public:
  /// Makes room. Sets no hit for any ray.
  void Allocate(std::size_t rays);

  /// Returns where to store the hits that a caster found before it refined their ranges and before
  /// limits applied; null without room.
  lms3dBeamHits GetNearest()
  {
    return this->Ranges.empty() ? lms3dBeamHits{ nullptr, nullptr }
                                : lms3dBeamHits{ this->Ranges.data(), this->Triangles.data() };
  }

  /**
   * Replaces `ranges` (metres, NaN without a return) by the ranges of the nearest hits of all
   * processes, and `triangles` by 0 where there is a return, lms3dBeamPacket::NoTriangle where
   * there is none. Removes the hits of this process that gave no return. Its triangles belong to
   * cells that are numbered from `firstCell`. `caster` is null if the part has no triangles.
   * Collective.
   */
  void ReduceToNearest(const lms3dProcesses& processes, const lms3dRayCaster* caster,
    std::int64_t firstCell, double* ranges, std::int32_t* triangles);

  /// The triangle of each ray, lms3dBeamPacket::NoTriangle if there is none.
  std::vector<std::int32_t> Triangles;

  /// The cells of the nearest hits of all processes. Set by ReduceToNearest.
  std::vector<vtkIdType> Cells;

private:
  std::vector<double> Ranges;
};

#endif
