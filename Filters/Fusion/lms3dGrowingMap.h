// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes of a fused map, and how a scan joins them.
 */
#ifndef lms3dGrowingMap_h
#define lms3dGrowingMap_h

#include "Device/lms3dScanInput.h"
#include "Fusion/lms3dFusedPlane.h"
#include "Fusion/lms3dLocalMap.h"
#include "Fusion/lms3dMapFusion.h"
#include "Fusion/lms3dPatchFit.h"
#include "Fusion/lms3dRegionMesher.h"
#include "Fusion/lms3dSeenRanges.h"
#include "Pipeline/lms3dProgress.h"

#include <array>
#include <deque>
#include <memory>
#include <vector>

class vtkPolyData;

class lms3dGrowingMap
{
public:
  explicit lms3dGrowingMap(const lms3dFusionSettings& settings);

  /// As lms3dMapFusion::Add().
  bool Add(vtkPolyData* map, const lms3dScanInput& scan, const lms3dProgress& progress);

  int GetNumberOfScans() const { return static_cast<int>(this->Positions.size()); }
  const std::vector<lms3dVector>& GetPositions() const { return this->Positions; }
  const std::deque<lms3dFusedPlane>& GetPlanes() const { return this->Planes; }

private:
  void AddTable(const lms3dScanInput& scan);
  bool Renew(const lms3dProgress& progress);
  void RenewPlane(int number);
  void Join(const lms3dLocalMap& local);
  int FindPlane(
    const lms3dLocalMap& local, const std::vector<int>& returns, const lms3dFittedPlane& fit) const;
  int MakePlane(const lms3dVector& point, const lms3dVector& normal);
  void AddTriangle(int plane, const lms3dLocalMap& local, int triangle);
  bool IsCovered(const lms3dFusedPlane& plane, const lms3dRasterBlock& block, std::int32_t u,
    std::int32_t v) const;
  bool AddReturn(int plane, const lms3dMappedReturn& mapped);
  void AddCreases(const lms3dLocalMap& local, const std::vector<int>& planeOfPatch);
  void AddRest(const lms3dLocalMap& local, const std::vector<bool>& isExplained,
    const std::vector<int>& planeOfPatch);
  int FindPlaneBeside(const lms3dLocalMap& local, const std::vector<int>& returns,
    const std::array<lms3dVector, 3>& corners, const lms3dVector& normal) const;
  void AddFacet(const lms3dMappedReturn& mapped);
  bool Shows(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const;
  std::vector<int> FindPlanesNear(
    const std::vector<lms3dMappedReturn>& returns, std::size_t end) const;
  double CountShown(
    const std::vector<int>& planes, const std::vector<lms3dMappedReturn>& returns) const;
  bool IsMostlyExplained(const std::vector<lms3dMappedReturn>& returns, std::size_t end) const;
  void DissolveWeakPlanes();
  void AddLoose(const lms3dLocalMap& local, const std::vector<int>& returns, int ownPlane,
    std::vector<bool>& isExplained);
  bool AddToPlanes(const std::vector<int>& planes, const lms3dMappedReturn& mapped);
  void MarkPassed(const lms3dSeenRanges& ranges, bool forgets, bool newBlocksOnly);
  std::vector<lms3dCreaseLine> GetCreaseLines(int plane) const;

  const lms3dFusionSettings Settings;
  const double Cell;
  std::shared_ptr<const lms3dBeamTable> Table;
  std::vector<lms3dVector> Positions;
  std::vector<std::unique_ptr<lms3dSeenRanges>> Seen;
  std::deque<lms3dFusedPlane> Planes;
};

#endif
