// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans with beams that have a width: casts the rays of each beam, and mixes them.
 */
#ifndef lms3dWideBeams_h
#define lms3dWideBeams_h

#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dProgress.h"
#include "Scan/lms3dDeviceSettings.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dPacketGrid.h"
#include "Scan/lms3dPartHits.h"
#include "Scan/lms3dRayFan.h"

#include <vtkType.h>

#include <cstdint>
#include <vector>

class lms3dRayCaster;

/// The results for all beams of the grid. The arrays belong to the caller.
struct lms3dMixedBeams
{
  /// The reported ranges, NaN without a return, and the triangles that gave them.
  lms3dBeamHits Returns;

  ///@{
  /// With several processes, the triangles of this process and the cells of all (lms3dPartHits);
  /// otherwise null.
  std::int32_t* OwnTriangles;
  vtkIdType* Cells;
  ///@}
};

/// Works block by block, to limit its memory: Cast, then ReduceToNearest in several processes, then
/// Mix.
class lms3dWideBeams
{
public:
  /// Beams and footprint must outlive the object. The limits hold for the reported ranges.
  lms3dWideBeams(
    const lms3dMovingBeams& beams, const lms3dFootprint& footprint, const lms3dRangeLimits& limits);

  int GetNumberOfBlocks() const;

  /// Casts the rays of a block of turns against the whole scene, or, if `isPart`, against this
  /// process's part; `caster` is null if the part has no triangles. Uses the threads of the calling
  /// TBB arena. Returns false if `progress` stopped it.
  bool Cast(int block, const lms3dRayCaster* caster, bool isPart, const lms3dProgress& progress);

  /// Replaces the results of Cast by the nearest hits of all processes, see lms3dPartHits.
  /// Collective.
  void ReduceToNearest(
    const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell);

  /// Sets the results of the beams of a block. Uses the threads of the calling TBB arena.
  void Mix(int block, const lms3dMixedBeams& mixed) const;

private:
  int GetFirstTurn(int block) const { return block * this->TurnsPerBlock; }
  int CountTurns(int block) const;
  double ToRangeOnAxis(double range, std::size_t ray) const;

  const lms3dMovingBeams& Beams;
  const lms3dFootprint& Footprint;
  const lms3dRangeLimits Limits;
  std::vector<lms3dRayFan> Fans;

  /// Along the most oblique ray, metres.
  double MaximumRayRange;

  int TurnsPerBlock;

  ///@{
  /// The hits of the block in the order of lms3dRayScanRequest, metres along the rays.
  std::vector<double> Ranges;
  std::vector<std::int32_t> Triangles;
  lms3dPartHits Part;
  ///@}
};

#endif
