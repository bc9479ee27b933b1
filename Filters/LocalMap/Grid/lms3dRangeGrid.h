// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan at their places in the grid of beams and turns.
 */
#ifndef lms3dRangeGrid_h
#define lms3dRangeGrid_h

#include "Device/lms3dScanGeometry.h"
#include "LocalMap/Grid/lms3dPaddedGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Each place holds a range and a vertex. Vertices are numbered by turn, then beam. The places of a
 * pole, where the beams of all turns are one, share one vertex: the return with the median range.
 *
 * Around the grid lie ghosts (lms3dPaddedGrid). Turns go round where it is closed, and beyond a pole a
 * fan goes on in the opposite turn: of an odd number of turns in the two beside it, the nearer return
 * of which has planes go farther. Other ghosts have no return, and none has a vertex.
 */
class lms3dRangeGrid
{
public:
  static constexpr std::int32_t NoVertex = -1;

  /**
   * Takes a scan in, in the memory of the one before. `ranges` and `beamIds` belong to `count`
   * returns, in any order; the geometry is kept by reference. Throws std::runtime_error, with words
   * for the user, where a range is not a finite number above 0, or a beam is out of the grid or
   * given twice. Uses the threads of the calling TBB arena.
   */
  void Build(const lms3dScanGeometry& geometry, const double* ranges, const int* beamIds,
    std::int64_t count);

  const lms3dScanGeometry& GetGeometry() const { return *this->Geometry; }
  int GetNumberOfBeams() const { return this->Geometry->GetNumberOfBeams(); }
  int GetNumberOfTurns() const { return this->Geometry->GetNumberOfTurns(); }
  bool IsClosed() const { return this->Closed; }

  /// The beams that are the same in every turn.
  const std::vector<int>& GetPoles() const { return this->Poles; }
  /// Of each pole the ranges of all returns, metres, in no order.
  const std::vector<std::vector<double>>& GetRangesOfPoles() const { return this->RangesOfPoles; }

  /// For each beam of a turn metres, 0 where there is no return.
  const double* GetRanges(int turn) const { return this->Ranges.GetRow(turn); }
  /// For each beam of a turn a vertex or NoVertex.
  const std::int32_t* GetVertices(int turn) const { return this->Vertices.GetRow(turn); }

  /// The first vertex of a turn, or of a turn after it. Poles are vertices of turn 0.
  std::int32_t GetFirstVertex(int turn) const { return this->FirstVertices[turn]; }

  /// Whether a turn has any, that of a pole included.
  bool HasReturns(int turn) const
  {
    return this->HasPole || this->FirstVertices[turn] < this->FirstVertices[turn + 1];
  }

  double GetRange(int turn, int beam) const { return this->GetRanges(turn)[beam]; }
  std::int32_t GetVertex(int turn, int beam) const { return this->GetVertices(turn)[beam]; }
  bool HasReturn(int turn, int beam) const { return this->GetRange(turn, beam) > 0.0; }

  /// For each vertex the number of the return that it is.
  const std::vector<std::int32_t>& GetReturns() const { return this->Returns; }

private:
  void AssignReturns(const double* ranges, const int* beamIds, std::int64_t count);
  [[noreturn]] void ThrowBadReturn(std::int64_t index, double range, int beamId) const;
  void CollapsePole(int beam, const double* ranges);
  void CountVertices();
  void FillTurn(int turn, const double* ranges);
  void CopyPoleToTurns(int beam);
  void FillHaloBeams(int end, int outwards);
  double GetOppositeRange(int turn, int beam) const;

  const std::int32_t* GetReturnsOfTurn(int turn) const;

  const lms3dScanGeometry* Geometry = nullptr;
  bool Closed = false;
  bool HasPole = false;
  std::vector<int> Poles;
  std::vector<std::vector<double>> RangesOfPoles;
  /// By beam number, without ghosts.
  std::vector<std::int32_t> ReturnOfBeam;
  lms3dPaddedGrid<double> Ranges{ 0.0 };
  lms3dPaddedGrid<std::int32_t> Vertices{ NoVertex };
  /// Of each turn, and their number at the end.
  std::vector<std::int32_t> FirstVertices;
  std::vector<std::int32_t> Returns;
};

#endif
