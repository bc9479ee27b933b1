// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dTurnReturns.h"

#include "Kernels/lms3dPacketKernels.h"
#include "Scan/lms3dReturnRuns.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
// From this mean length on, it pays to fill the arrays run by run.
constexpr std::size_t MinimumRunLength = 8;

using Piece = lms3dReturnPiece;
using Run = lms3dReturnRun;

template <typename T, typename ValueOf>
void FillEach(T* out, int count, const ValueOf& valueOf)
{
  for (int i = 0; i < count; ++i)
  {
    out[i] = valueOf(i);
  }
}

void Widen(const std::int32_t* triangles, int count, long long* cells)
{
  lms3dGetPacketKernels().Returns.WidenTriangles(triangles, count, cells);
}

// For builds of VTK whose vtkIdType is another type.
template <typename Id>
void Widen(const std::int32_t* triangles, int count, Id* cells)
{
  std::copy_n(triangles, count, cells);
}

/// Fills the arrays of one scan. In the methods, `beamOf` maps a return of a piece to its beam in
/// the turn.
class Filler
{
public:
  Filler(const lms3dTurnReturns& turns, const lms3dReturns& returns, vtkIdType* cellIds)
    : Turns(turns)
    , Returns(returns)
    , CellIds(cellIds)
  {
  }

  void FillRuns(const std::vector<Run>& runs) const
  {
    const lms3dReturnKernels& kernels = lms3dGetPacketKernels().Returns;
    for (const Run& run : runs)
    {
      kernels.FillRun(this->GetArrays(run));
      this->FillCells(run);
      this->Locate(run.Returns, this->GetGeometry().GetAlphaCosines().data() + run.FirstBeam,
        this->GetGeometry().GetAlphaSines().data() + run.FirstBeam);
    }
  }

  void FillHits(const Piece& piece, const std::vector<int>& hits) const
  {
    this->FillArrays(piece, hits);
    std::vector<double> cosines(piece.Count), sines(piece.Count);
    for (int i = 0; i < piece.Count; ++i)
    {
      cosines[i] = this->GetGeometry().GetAlphaCosine(hits[i]);
      sines[i] = this->GetGeometry().GetAlphaSine(hits[i]);
    }
    this->Locate(piece, cosines.data(), sines.data());
  }

  // For beams that start anywhere, and at any angles of the platform.
  void FillAnywhere(const Piece& piece, const std::vector<int>& hits) const
  {
    this->FillArrays(piece, hits);
    const lms3dTurnFrame frame = this->Turns.Beams->GetFrame(piece.Turn);
    const lms3dFan& fan = this->Turns.Beams->GetFan();
    const double beta = this->GetGeometry().GetBetaAngles()[piece.Turn];
    const double* ranges = this->Turns.Ranges + this->GetFirst(piece);
    for (int i = 0; i < piece.Count; ++i)
    {
      const lms3dVector point = lms3dAdd(frame.ToPoint(fan.Origins[hits[i]]),
        lms3dScale(frame.ToWorld(fan.Directions[hits[i]]), ranges[hits[i]]));
      std::copy(point.begin(), point.end(), this->Returns.Point + 3 * (piece.Slot + i));
      this->Returns.Beta[piece.Slot + i] = static_cast<float>(beta + fan.TurnedAngles[hits[i]]);
    }
  }

private:
  void FillCells(const Run& run) const
  {
    const Piece& piece = run.Returns;
    if (this->Turns.Mesh && this->Turns.Mesh->Cells.empty())
    {
      Widen(this->Turns.Triangles + this->GetFirst(piece) + run.FirstBeam, piece.Count,
        this->CellIds + piece.Slot);
    }
    else
    {
      this->FillCells(piece, [first = run.FirstBeam](int i) { return first + i; });
    }
  }

  lms3dReturnRunArrays GetArrays(const Run& run) const
  {
    const Piece& piece = run.Returns;
    const std::size_t first = this->GetFirst(piece) + run.FirstBeam;
    const std::size_t slot = piece.Slot;
    return { piece.Count, this->Turns.Ranges + first,
      this->GetGeometry().GetAlphaAngles().data() + run.FirstBeam,
      static_cast<float>(this->GetGeometry().GetBetaAngles()[piece.Turn]),
      static_cast<std::int32_t>(first), static_cast<std::int32_t>(slot), this->Returns.Range + slot,
      this->Returns.Alpha + slot, this->Returns.Beta + slot, this->Returns.BeamId + slot,
      this->Returns.VertexOffsets->GetPointer(0) + slot,
      this->Returns.VertexPoints->GetPointer(0) + slot };
  }

  const lms3dScanGeometry& GetGeometry() const { return this->Turns.Geometry; }

  // Returns the number of the first beam of the piece's turn.
  std::size_t GetFirst(const Piece& piece) const
  {
    return static_cast<std::size_t>(piece.Turn) * this->GetGeometry().GetNumberOfBeams();
  }

  void FillArrays(const Piece& piece, const std::vector<int>& hits) const
  {
    const auto beamOf = [&hits](int i) { return hits[i]; };
    this->FillRange(piece, beamOf);
    this->FillCells(piece, beamOf);
    this->FillAlpha(piece, beamOf);
    this->FillBeta(piece);
    this->FillBeamId(piece, beamOf);
    this->FillVertices(piece);
  }

  template <typename BeamOf>
  void FillRange(const Piece& piece, const BeamOf& beamOf) const
  {
    if (this->Returns.Range == this->Turns.Ranges)
    {
      return;
    }
    const double* ranges = this->Turns.Ranges + this->GetFirst(piece);
    FillEach(
      this->Returns.Range + piece.Slot, piece.Count, [&](int i) { return ranges[beamOf(i)]; });
  }

  // The choice between the three sources stands outside the loops, so that the compiler can
  // vectorize them.
  template <typename BeamOf>
  void FillCells(const Piece& piece, const BeamOf& beamOf) const
  {
    vtkIdType* cellIds = this->CellIds + piece.Slot;
    const std::size_t first = this->GetFirst(piece);
    if (!this->Turns.Mesh)
    {
      const vtkIdType* cells = this->Turns.Cells + first;
      FillEach(cellIds, piece.Count, [&](int i) { return cells[beamOf(i)]; });
      return;
    }
    const std::int32_t* triangles = this->Turns.Triangles + first;
    if (this->Turns.Mesh->Cells.empty())
    {
      FillEach(cellIds, piece.Count, [&](int i) { return vtkIdType(triangles[beamOf(i)]); });
    }
    else
    {
      const std::int64_t* cells = this->Turns.Mesh->Cells.data();
      FillEach(cellIds, piece.Count, [&](int i) { return vtkIdType(cells[triangles[beamOf(i)]]); });
    }
  }

  template <typename BeamOf>
  void FillAlpha(const Piece& piece, const BeamOf& beamOf) const
  {
    const double* alpha = this->GetGeometry().GetAlphaAngles().data();
    FillEach(this->Returns.Alpha + piece.Slot, piece.Count,
      [&](int i) { return static_cast<float>(alpha[beamOf(i)]); });
  }

  void FillBeta(const Piece& piece) const
  {
    std::fill_n(this->Returns.Beta + piece.Slot, piece.Count,
      static_cast<float>(this->GetGeometry().GetBetaAngles()[piece.Turn]));
  }

  template <typename BeamOf>
  void FillBeamId(const Piece& piece, const BeamOf& beamOf) const
  {
    const int first = static_cast<int>(this->GetFirst(piece));
    FillEach(
      this->Returns.BeamId + piece.Slot, piece.Count, [&](int i) { return first + beamOf(i); });
  }

  void FillVertices(const Piece& piece) const
  {
    const vtkIdType first = static_cast<vtkIdType>(piece.Slot);
    this->Returns.FillVertices(first, first + piece.Count);
  }

  // Needs the piece's Range.
  void Locate(const Piece& piece, const double* cosines, const double* sines) const
  {
    const lms3dReturnsOfTurn located = { cosines, sines, this->Returns.Range + piece.Slot,
      piece.Count, this->Turns.Directions.GetFanAxis(piece.Turn).data(),
      this->Turns.Directions.GetUp().data(), this->Turns.Position.data() };
    lms3dGetPacketKernels().Locate(located, this->Returns.Point + 3 * piece.Slot);
  }

  const lms3dTurnReturns& Turns;
  const lms3dReturns& Returns;
  vtkIdType* const CellIds;
};
} // namespace

void lms3dTurnReturns::Fill(int begin, int end, const std::vector<std::size_t>& slots,
  const lms3dReturns& returns, vtkIdType* cellIds) const
{
  const int beams = this->Geometry.GetNumberOfBeams();
  const Filler filler(*this, returns, cellIds);
  std::vector<Run> runs;
  for (int turn = begin; turn < end; ++turn)
  {
    const Piece piece = { turn, static_cast<int>(slots[turn + 1] - slots[turn]), slots[turn] };
    const std::int32_t* triangles = this->Triangles + static_cast<std::ptrdiff_t>(turn) * beams;
    if (piece.Count == 0)
    {
      continue;
    }
    if (this->Beams)
    {
      filler.FillAnywhere(piece, lms3dFindHits(triangles, beams));
    }
    else if (piece.Count == beams)
    {
      runs.push_back({ piece, 0 });
    }
    else if (!lms3dFindRuns(triangles, beams, piece, MinimumRunLength, runs))
    {
      filler.FillHits(piece, lms3dFindHits(triangles, beams));
    }
  }
  filler.FillRuns(runs);
}
