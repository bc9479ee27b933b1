// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan in the grid of the map.
 */
#ifndef lms3dMapScan_h
#define lms3dMapScan_h

#include "Geometry/lms3dVector.h"
#include "LocalMap/Grid/lms3dMapGeometry.h"

#include <array>
#include <cstdint>
#include <vector>

class lms3dScanInput;

/// Shares the arrays of the scan where the grid of the map is that of the scan.
class lms3dMapScan
{
public:
  /// Keeps references. The scan must have returns and the grid of `geometry.GetScanned()`. Throws
  /// std::runtime_error, with a text for the user, if a return is bad and its beam has another
  /// place in the grid of the map.
  lms3dMapScan(const lms3dScanInput& scan, const lms3dMapGeometry& geometry);

  const lms3dMapGeometry& GetGeometry() const { return this->Geometry; }

  /// The number of returns that have a place in the grid.
  std::int64_t GetNumberOfReturns() const { return this->Count; }

  /// The number of returns whose turns repeat others.
  std::int64_t GetNumberOfRepeatedReturns() const { return this->Repeated; }

  /// Metres along the beam.
  const double* GetRanges() const { return this->Ranges; }

  /// Turn * beams + beam in the grid of the map. The values are not checked if the scan's grid is
  /// shared.
  const int* GetBeamIds() const { return this->BeamIds; }

  /// World coordinates, metres, three for each return.
  const double* GetPoints() const { return this->Points; }

  /// The distances from the origin of the map's frame, metres.
  const double* GetDistances() const { return this->Distances; }

  /// The rotation and the origin of the map's frame as 16 values, row by row.
  const double* GetMapToWorld() const { return this->MapToWorld.data(); }

  /// World coordinates, metres.
  lms3dVector GetOrigin() const
  {
    return { this->MapToWorld[3], this->MapToWorld[7], this->MapToWorld[11] };
  }

private:
  void SetFrame(const lms3dScanInput& scan);
  void Unfold(const lms3dScanInput& scan);
  void MeasureDistances();

  const lms3dMapGeometry& Geometry;
  std::int64_t Count;
  std::int64_t Repeated = 0;
  const double* Ranges;
  const int* BeamIds;
  const double* Points;
  const double* Distances;
  std::array<double, 16> MapToWorld;
  ///@{
  /// Empty if shared.
  std::vector<double> OwnRanges;
  std::vector<int> OwnBeamIds;
  std::vector<double> OwnPoints;
  std::vector<double> OwnDistances;
  ///@}
};

#endif
