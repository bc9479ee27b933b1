// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A map of many scans that grows scan by scan.
 */
#ifndef lms3dMapFusion_h
#define lms3dMapFusion_h

#include "Fusion/Cells/lms3dFusedMesh.h"
#include "Pipeline/lms3dProgress.h"

#include <memory>
#include <vector>

class vtkPolyData;

struct lms3dFusionSettings
{
  /// Metres, above 0.
  double MaximumError;
  bool KeepReturns;
  bool ForgetSeenThrough;

  bool operator==(const lms3dFusionSettings& other) const
  {
    return this->MaximumError == other.MaximumError && this->KeepReturns == other.KeepReturns &&
      this->ForgetSeenThrough == other.ForgetSeenThrough;
  }
};

class lms3dMapFusion
{
public:
  /// `firstRegion` is the first RegionId, `revision` the number before that of the first scan.
  lms3dMapFusion(const lms3dFusionSettings& settings, int firstRegion, int revision);
  ~lms3dMapFusion();
  lms3dMapFusion(const lms3dMapFusion&) = delete;
  lms3dMapFusion& operator=(const lms3dMapFusion&) = delete;

  /// Throws std::runtime_error, with a text for the user, if the scan or its map is invalid.
  /// Nothing changes then.
  void Check(vtkPolyData* map, vtkPolyData* scan) const;

  /// Adds a scan that was checked. Returns false, with a map that is not of use any more, if
  /// `progress` stopped the work. Uses the threads of the calling TBB arena.
  bool Add(vtkPolyData* map, vtkPolyData* scan, const lms3dProgress& progress);

  int GetNumberOfScans() const;
  int GetRevision() const;
  /// The RegionIds of this map are at least the first one and below this.
  int GetEndOfRegions() const;
  const lms3dFusionSettings& GetSettings() const;

  /// Fills an empty output with the regions that changed after a revision.
  void Fill(int sinceRevision, vtkPolyData* output) const;

  /// The RegionIds of these regions.
  std::vector<int> GetChangedRegions(int sinceRevision) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
