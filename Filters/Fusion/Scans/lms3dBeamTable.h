// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams of a device in the sensor's frame, and which of them can meet a sphere.
 */
#ifndef lms3dBeamTable_h
#define lms3dBeamTable_h

#include "Device/lms3dScanGeometry.h"
#include "Geometry/lms3dVector.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

/// Scans with equal angles share one table. Vectors are in the sensor frame.
class lms3dBeamTable
{
public:
  explicit lms3dBeamTable(const lms3dScanGeometry& geometry);

  const lms3dScanGeometry& GetGeometry() const { return this->Geometry; }
  /// The number of beams.
  int GetSize() const { return this->Size; }
  /// The number of beams of a fan.
  int GetBeamsOfFan() const { return this->Beams; }
  const lms3dVector& GetDirection(int beamId) const { return this->Directions[beamId]; }

  /// Metres. Zeros if all beams start at the sensor's position.
  lms3dVector GetStart(int beamId) const
  {
    return this->Starts.empty() ? lms3dVector{ 0.0, 0.0, 0.0 } : this->Starts[beamId];
  }
  bool HasStarts() const { return !this->Starts.empty(); }

  /// The next beam in the fan or the beam of the next turn; -1 beyond the end.
  int GetNextInFan(int beamId) const { return (beamId + 1) % this->Beams == 0 ? -1 : beamId + 1; }
  int GetNextTurn(int beamId) const
  {
    const int next = beamId + this->Beams;
    return next < this->Size ? next : (this->IsClosed ? next - this->Size : -1);
  }

  /// The next beam in the fan, the one that is next in both ways, and the beam of the next turn; -1
  /// beyond the end.
  std::array<int, 3> GetNeighbours(int beamId) const
  {
    const int turnId = this->GetNextTurn(beamId);
    return { this->GetNextInFan(beamId), turnId < 0 ? -1 : this->GetNextInFan(turnId), turnId };
  }

  ///@{
  /// Bins of directions. A beam belongs to one.
  int GetNumberOfBins() const { return Rows * Columns; }
  int GetBin(int beamId) const { return this->Bins[beamId]; }
  ///@}

  ///@{
  /// The place of a beam in the order of the bins, and the beam of a place.
  int GetPlace(int beamId) const { return this->Places[beamId]; }
  int GetBeam(int place) const { return this->Sorted[place]; }
  int GetFirstPlace(int bin) const { return this->BinStarts[bin]; }
  int GetEndOfPlaces(int bin) const { return this->BinStarts[bin + 1]; }
  /// A coordinate of the directions in the order of places, in single precision.
  const float* GetNarrowDirections(int axis) const { return this->NarrowDirections[axis].data(); }
  ///@}

  /// Adds the bins whose beams can meet a sphere.
  void FindBins(const lms3dVector& centre, double radius, std::vector<int>& bins) const;

private:
  static constexpr int Rows = 90;
  static constexpr int Columns = 180;

  static int GetRow(double elevation);
  static int GetColumn(double azimuth);
  void FillBeams();
  void FillBins();

  lms3dScanGeometry Geometry;
  int Beams;
  int Size;
  bool IsClosed;
  /// Metres: how far a start is from the sensor's position.
  double LargestStart = 0.0;
  std::vector<lms3dVector> Directions;
  std::vector<lms3dVector> Starts;
  std::vector<int> Bins;
  std::vector<int> BinStarts;
  std::vector<int> Sorted;
  std::vector<int> Places;
  std::array<std::vector<float>, 3> NarrowDirections;
};

/// The tables of scans by their numbers; nullptr for a scan whose map is empty.
using lms3dTablesOfScans = std::vector<std::shared_ptr<const lms3dBeamTable>>;

#endif
