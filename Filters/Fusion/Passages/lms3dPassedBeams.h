// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Marks where the beams of a scan passed through a plane.
 */
#ifndef lms3dPassedBeams_h
#define lms3dPassedBeams_h

#include "Fusion/Passages/lms3dPassages.h"
#include "Fusion/Planes/lms3dBlockGroups.h"
#include "Fusion/Planes/lms3dFusedPlane.h"
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <cstddef>
#include <cstdint>

/// Keeps memory from plane to plane.
class lms3dPassedBeams
{
public:
  /// A beam passed if it is free beyond the plane by more than `maximumError`, metres. If
  /// `forgets`, the returns of other scans between beams that all passed are taken out.
  lms3dPassedBeams(double maximumError, bool forgets)
    : Forgets(forgets)
    , Passages(maximumError)
  {
  }

  /// Sets Passed of the blocks of a plane that are in groups, and Open between the beams that
  /// passed them.
  void Mark(const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, const lms3dBlockGroups& groups);

private:
  /// The block that was found last: successive beams often pass through one block.
  class LastFound
  {
  public:
    /// The number of a block, -1 if there is none.
    int Find(std::int32_t u, std::int32_t v, const lms3dRaster& raster)
    {
      if (!this->IsKnown || u != this->U || v != this->V)
      {
        *this = LastFound(u, v, raster.Find(u, v));
      }
      return this->Number;
    }

    int GetNumber() const { return this->Number; }

    /// Whether all cells of a box lie in the block.
    bool Has(const lms3dCellBox& box) const
    {
      return this->Number >= 0 && lms3dRaster::GetBlockOf(box.Left) == this->U &&
        lms3dRaster::GetBlockOf(box.Right) == this->U &&
        lms3dRaster::GetBlockOf(box.Bottom) == this->V &&
        lms3dRaster::GetBlockOf(box.Top) == this->V;
    }

    LastFound() = default;

  private:
    LastFound(std::int32_t u, std::int32_t v, int number)
      : U(u)
      , V(v)
      , Number(number)
      , IsKnown(true)
    {
    }

    std::int32_t U = 0;
    std::int32_t V = 0;
    int Number = -1;
    bool IsKnown = false;
  };

  void MarkBeam(
    const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, int firstBlock, std::size_t number);
  bool IsOpen(const lms3dRaster& raster, const lms3dCellBox& box) const;
  void MarkAround(const lms3dBeamTable& table, lms3dFusedPlane& plane, std::size_t number) const;
  template <typename Points>
  void Open(lms3dFusedPlane& plane, const Points& points) const;

  const bool Forgets;
  lms3dPassages Passages;
  LastFound LastBlock;
};

#endif
