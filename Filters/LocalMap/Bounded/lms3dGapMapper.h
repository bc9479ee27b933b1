// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the map within an error bound of a scan with gaps and speckles.
 */
#ifndef lms3dGapMapper_h
#define lms3dGapMapper_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Gaps/lms3dSurfaceGaps.h"
#include "Pipeline/lms3dProgress.h"

#include <optional>
#include <vector>

class lms3dMapScan;
class vtkPolyData;

/**
 * Fills the beams of gaps and speckles (lms3dSurfaceGaps), makes the map (lms3dBoundedMesher), and
 * adds facets for the returns of speckles. If the map must be the plain grid, gaps stay open, and
 * the returns of speckles are parts of the grid or left out. Without a size of gaps and speckles,
 * the grid stays as it is.
 */
class lms3dGapMapper
{
public:
  /// Keeps references. `grid` has the returns of `scan`. `keepsSpeckles` says whether speckles get
  /// facets. `isFree` is that of lms3dSurfaceGaps.
  lms3dGapMapper(const lms3dMapScan& scan, lms3dRangeGrid& grid, lms3dRangeJoins& joins,
    const lms3dGapSettings& settings, bool keepsSpeckles, const std::vector<bool>& isFree);

  /// Makes the map. To be called once. There is none if `progress` returned false. Uses the threads
  /// of the calling TBB arena. Throws std::runtime_error as lms3dBoundedMesher does.
  std::optional<lms3dBoundedMap> MakeMap(const lms3dProgress& progress);

  /// Adds the field data about gaps and speckles to the output, if their sizes are above 0.
  void FillOutput(const lms3dBoundedMap& bounded, vtkPolyData* map) const;

private:
  std::optional<lms3dBoundedMap> MakeMapWithoutGaps(const lms3dProgress& progress);
  void LeaveSpecklesOut();
  void FillGaps(const lms3dBoundedMap& bounded, vtkPolyData* map) const;
  void FillSpeckles(vtkPolyData* map) const;

  const lms3dMapScan& Scan;
  lms3dRangeGrid& Grid;
  lms3dRangeJoins& Joins;
  const lms3dGapSettings Settings;
  const bool KeepsSpeckles;
  const std::vector<bool>& IsFree;
  /// SpeckleBeams is empty if the map treats speckles as parts of the surface.
  std::vector<lms3dGapBeam> GapBeams;
  std::vector<lms3dGapBeam> SpeckleBeams;
};

#endif
