// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan at their places in the grid of beams and turns.
 */
#ifndef lms3dRangeGrid_h
#define lms3dRangeGrid_h

#include "lms3dScanGeometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Each place holds a range and a vertex. The places of a pole, where the beams of all turns are
 * one, share one vertex: the return with the median range.
 */
class lms3dRangeGrid
{
public:
  static constexpr std::int64_t NoVertex = -1;

  /**
   * `ranges` and `beamIds` belong to `count` returns. Throws std::runtime_error, with words for the
   * user, where a range is not a finite number above 0, or a beam is out of the grid or given
   * twice.
   */
  lms3dRangeGrid(
    lms3dScanGeometry geometry, const double* ranges, const int* beamIds, std::int64_t count);

  const lms3dScanGeometry& GetGeometry() const { return this->Geometry; }
  int GetNumberOfBeams() const { return this->Geometry.GetNumberOfBeams(); }
  int GetNumberOfTurns() const { return this->Geometry.GetNumberOfTurns(); }
  bool IsClosed() const { return this->Closed; }

  /// Turns go round where the grid is closed; a place outside of the grid has no return.
  bool HasReturn(int turn, int beam) const { return this->GetRange(turn, beam) > 0.0; }

  /// Metres, 0 where there is no return.
  double GetRange(int turn, int beam) const
  {
    const std::ptrdiff_t place = this->GetPlace(turn, beam);
    return place < 0 ? 0.0 : this->Ranges[place];
  }

  std::int64_t GetVertex(int turn, int beam) const
  {
    const std::ptrdiff_t place = this->GetPlace(turn, beam);
    return place < 0 ? NoVertex : this->Vertices[place];
  }

  /// For each vertex the number of the return that it is.
  const std::vector<std::int64_t>& GetReturns() const { return this->Returns; }

private:
  std::ptrdiff_t GetPlace(int turn, int beam) const;
  void Place(const double* ranges, const int* beamIds, std::int64_t count);
  void JoinPole(int beam);
  void NumberVertices();

  lms3dScanGeometry Geometry;
  bool Closed;
  std::vector<double> Ranges;
  std::vector<std::int64_t> Vertices;
  std::vector<std::int64_t> Returns;
};

#endif
