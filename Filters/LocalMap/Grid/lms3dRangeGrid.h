// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns of a scan, sorted into the grid of turns and beams.
 */
#ifndef lms3dRangeGrid_h
#define lms3dRangeGrid_h

#include "Device/lms3dScanGeometry.h"
#include "LocalMap/Grid/lms3dPaddedGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// A beam that gets a range instead of its return.
struct lms3dFilledBeam
{
  int Turn;
  int Beam;
  /// Metres.
  double Range;
};

/**
 * Each beam of each turn has a range, metres, 0 without a return, and a vertex number. Vertices are
 * numbered by turn, then by beam.
 *
 * A pole is a beam along the platform's axis; it is the same in every turn. All its entries share
 * one vertex: the return of median range.
 *
 * A halo surrounds the grid (lms3dPaddedGrid). If the turns close a full circle, the halo repeats
 * them, and beyond a pole a fan continues in the opposite turn. (An odd number of turns has no
 * opposite turn; the nearer return of the two turns beside it is used, whose planes extend
 * farther.) Elsewhere the halo has no returns. It never has vertices.
 */
class lms3dRangeGrid
{
public:
  static constexpr std::int32_t NoVertex = -1;

  /**
   * Replaces the content by a scan and reuses the memory. `ranges`, metres, and `beamIds` (turn
   * times number of beams plus beam) belong to `count` returns, in any order. Keeps a reference to
   * the geometry. Uses the threads of the calling TBB arena.
   *
   * Throws std::runtime_error, with a message for the user, if a range is not a finite number above
   * 0, or if a beam is outside of the grid or has two returns.
   */
  void Build(const lms3dScanGeometry& geometry, const double* ranges, const int* beamIds,
    std::int64_t count);

  /// Gives beams a range and takes their vertices away. None of them may be a pole. The numbers of
  /// vertices and returns do not change.
  void Fill(const std::vector<lms3dFilledBeam>& beams);

  const lms3dScanGeometry& GetGeometry() const { return *this->Geometry; }
  int GetNumberOfBeams() const { return this->Geometry->GetNumberOfBeams(); }
  int GetNumberOfTurns() const { return this->Geometry->GetNumberOfTurns(); }
  bool IsClosed() const { return this->Closed; }

  /// The beams that are poles.
  const std::vector<int>& GetPoles() const { return this->Poles; }
  /// The ranges of all returns of each pole, metres, in no particular order.
  const std::vector<std::vector<double>>& GetRangesOfPoles() const { return this->RangesOfPoles; }

  /// The range of each beam of a turn.
  const double* GetRanges(int turn) const { return this->Ranges.GetRow(turn); }
  /// The vertex of each beam of a turn, or NoVertex.
  const std::int32_t* GetVertices(int turn) const { return this->Vertices.GetRow(turn); }

  /// The first vertex of a turn or, if it has none, of the turns after it. Poles belong to turn 0.
  std::int32_t GetFirstVertex(int turn) const { return this->FirstVertices[turn]; }

  /// Whether a turn has a return, of a pole or another.
  bool HasReturns(int turn) const
  {
    return this->HasPole || this->FirstVertices[turn] < this->FirstVertices[turn + 1];
  }

  double GetRange(int turn, int beam) const { return this->GetRanges(turn)[beam]; }
  std::int32_t GetVertex(int turn, int beam) const { return this->GetVertices(turn)[beam]; }
  bool HasReturn(int turn, int beam) const { return this->GetRange(turn, beam) > 0.0; }

  /// The length or the largest range, metres, whichever is smaller.
  double LimitToLargestRange(double length) const;

  ///@{
  /// Whether Fill() gave a range to any beam, and to this one.
  bool HasFilledBeams() const { return this->HasFilled; }
  bool IsFilled(int turn, int beam) const
  {
    return this->HasReturn(turn, beam) && this->GetVertex(turn, beam) == NoVertex;
  }
  ///@}

  /// The number of the return of each vertex, as in the arrays given to Build().
  const std::vector<std::int32_t>& GetReturns() const { return this->Returns; }

private:
  static constexpr std::int32_t NoReturn = -1;

  void AssignReturns(const double* ranges, const int* beamIds, std::int64_t count);
  bool AreSorted(const double* ranges, const int* beamIds, std::int64_t count) const;
  void AssignSortedReturns(const int* beamIds, std::int64_t count);
  void CollapsePole(int beam, const double* ranges);
  void CountVertices();
  void FillTurn(int turn, const double* ranges);
  void CopyPoleToTurns(int beam);
  void FillHalo();
  void FillHaloBeams(int end, int outwards);
  double GetOppositeRange(int turn, int beam) const;

  const std::int32_t* GetReturnsOfTurn(int turn) const;

  const lms3dScanGeometry* Geometry = nullptr;
  bool Closed = false;
  bool HasPole = false;
  bool HasFilled = false;
  std::vector<int> Poles;
  std::vector<std::vector<double>> RangesOfPoles;
  /// The return of each BeamId, or NoReturn.
  std::vector<std::int32_t> ReturnOfBeam;
  lms3dPaddedGrid<double> Ranges{ 0.0 };
  lms3dPaddedGrid<std::int32_t> Vertices{ NoVertex };
  /// The first vertex of each turn, then the number of all vertices.
  std::vector<std::int32_t> FirstVertices;
  std::vector<std::int32_t> Returns;
};

#endif
