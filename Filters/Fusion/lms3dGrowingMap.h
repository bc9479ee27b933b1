// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes of a fused map, and how a scan joins them.
 */
#ifndef lms3dGrowingMap_h
#define lms3dGrowingMap_h

#include "Device/lms3dScanInput.h"
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Scans/lms3dSeenRanges.h"
#include "Fusion/lms3dMapFusion.h"
#include "Pipeline/lms3dProgress.h"

#include <memory>
#include <vector>

class vtkPolyData;

class lms3dGrowingMap
{
public:
  explicit lms3dGrowingMap(const lms3dFusionSettings& settings);

  /// As lms3dMapFusion::Add().
  bool Add(vtkPolyData* map, vtkPolyData* scan, const lms3dProgress& progress);

  int GetNumberOfScans() const { return static_cast<int>(this->Positions.size()); }
  const std::vector<lms3dVector>& GetPositions() const { return this->Positions; }
  const lms3dFusedPlanes& GetPlanes() const { return this->Planes; }
  /// A region keeps its number.
  const std::vector<const lms3dFusedTile*>& GetRegions() const { return this->Regions; }

private:
  struct TileToRenew
  {
    int Plane;
    lms3dFusedTile* Tile;
    /// The creases of the plane, if the tile gets new triangles.
    std::shared_ptr<const std::vector<lms3dCreaseLine>> Creases;
  };

  void AddTable(const lms3dScanInput& scan);
  bool Reduce(const lms3dProgress& progress);
  bool Renew(const lms3dProgress& progress);
  void RenewShape(int number);
  std::vector<TileToRenew> FindTiles(const std::vector<int>& planes);
  void RenewTile(const TileToRenew& place);

  const lms3dFusionSettings Settings;
  std::shared_ptr<const lms3dBeamTable> Table;
  /// The tables of all scans, if returns are kept; otherwise nullptr for each.
  lms3dTablesOfScans Tables;
  std::vector<lms3dVector> Positions;
  std::vector<std::unique_ptr<lms3dSeenRanges>> Seen;
  lms3dFusedPlanes Planes;
  std::vector<const lms3dFusedTile*> Regions;
  /// The number of scans when meshes were last made.
  int MeshedRevision = 0;
  /// The number of scans when loose regions were last looked at.
  int LooseRevision = 0;
  /// The returns of the last local map. The next one uses their memory.
  std::vector<lms3dMappedReturn> Returns;
};

#endif
