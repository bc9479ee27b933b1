// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The gates between neighbouring beams of different patches, and the borders through them.
 *
 * This header defines the words of the folder. The figure shows beams as the sensor sees them: rows
 * of lms3dBeamSphere grow upwards, columns to the right. Letters name the patch of each return.
 *
 *        A           A     :     B           B
 *        o-----------o-----+-----o-----------o      o     a beam
 *        |           |    e:t    |           |      +     a gate
 *        |           |     :     |           |      : .   a border
 *      ..+...........+.....J.....+...........+..    J     a junction
 *        |           |           |           |      e t   the two edges of a gate
 *        |   cell    |   cell    |   cell    |
 *        o-----------o-----------o-----------o
 *        C           C           C           C
 *
 * - **Gate**: the arc between two neighbouring beams that belong to different patches, or that lie
 *   on both sides of a depth step. A border passes through the gate between its two ends and never
 *   touches a beam. Therefore straightening a border never changes on which side of it a beam lies.
 * - **Edge**: one side of a gate, as a half-edge of a polygon mesh. Each gate has two edges, twins,
 *   one for the beam at each end (the edge's owner). An edge runs with its owner's patch to the
 *   left: in the figure, edge e of A runs up, its twin t of B runs down. The edge of an owner
 *   without a patch is void.
 * - **Cell**: the quadrilateral between four neighbouring beams. Inside a cell, a border runs
 *   straight from gate to gate. The corners of a cell are numbered clockwise from the lower left
 *   one.
 * - **Junction**: the point inside a cell at which borders end, because more than two patches or
 *   more than one kind of gate meet there.
 * - **Chain** (lms3dBorderChains): the edges of a border from junction to junction, or all around.
 */
#ifndef lms3dBorderGates_h
#define lms3dBorderGates_h

#include "LocalMap/Patches/lms3dBeamVector.h"
#include "LocalMap/Patches/lms3dPatches.h"

#include <array>
#include <cstdint>
#include <vector>

class lms3dLabelChanges;

/// Finds all gates of a set of patches, and the order of the edges around each patch.
class lms3dBorderGates
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  enum GateKind : std::uint8_t
  {
    /// A depth step, or an end without a return. Each side has a border of its own, and the surface
    /// is open between them.
    DepthStep,
    /// One surface, and the planes of both patches meet in the gate. Both sides share one border.
    Crease,
    /// One surface, but the planes do not meet in the gate. Each side has a border of its own, and
    /// a strip of triangles joins the two (lms3dOffsetStrips).
    Offset
  };

  /// Positions in a gate are shares of its chord: 0 at the first end, 1 at the second.
  struct Gate
  {
    /// The beams at both ends. The second lies above the first, or to its right.
    std::array<GridIndex, 2> Ends;
    GateKind Kind;
    /// Borders must pass between Low and High, and preferably at Best.
    double Low;
    double High;
    double Best;
  };

  /// The share of a gate at each end that borders keep clear, so that no border grazes a beam.
  static constexpr double Margin = 0.1;
  /// The same at depth steps if beams are regular. There, a border has no strip beside it.
  static constexpr double DepthStepMargin = 0.02;
  /// The same at creases. There a grazed beam meets either side at the right range.
  static constexpr double CreaseMargin = 0.001;
  /// Stands for a gate or an edge that does not exist.
  static constexpr int NoGate = -1;

  /**
   * `tolerance` is the largest difference between the two planes of a crease, metres along the
   * beam; it is above 0. Keeps references to the sphere and the patches, which must not change
   * afterwards. Uses the threads of the calling TBB arena.
   */
  lms3dBorderGates(const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance);

  /// Edges are numbered from 0. The edges 2 i and 2 i + 1 belong to gate i.
  int GetNumberOfEdges() const { return 2 * static_cast<int>(this->Gates.size()); }
  const Gate& GetGate(int edge) const { return this->Gates[edge / 2]; }
  static int GetTwin(int edge) { return edge ^ 1; }
  /// The beam on whose side of the gate the edge lies.
  GridIndex GetOwner(int edge) const { return this->Gates[edge / 2].Ends[edge & 1]; }
  /// The patch of the edge's owner; negative for void edges.
  std::int32_t GetPatch(int edge) const { return this->Patches.Labels[this->GetOwner(edge)]; }
  bool IsVoid(int edge) const { return this->GetPatch(edge) < 0; }
  /// The side of the owner on which the edge lies, an lms3dBeamSphere::Side.
  int GetSide(int edge) const;
  /// Metres, as given to the constructor.
  double GetTolerance() const { return this->Tolerance; }

  /// Whether a patch has too few returns for its plane to be reliable beyond them.
  bool HasFewReturns(std::int32_t patch) const { return this->Patches.HasFewReturns(patch); }

  /// The edge that follows an edge around the same patch; NoGate for void edges.
  int GetNext(int edge) const { return this->Next[edge]; }

  /// Whether an edge and the next one belong to one chain: no junction lies between them.
  bool IsRegular(int edge) const;

  struct Cell
  {
    /// Identifies the cell. It is also the first corner.
    GridIndex LowerLeft;
    /// Clockwise from the lower left one.
    std::array<GridIndex, 4> Corners;
  };

  /// `lowerLeft` must not lie in the highest row.
  Cell GetCell(GridIndex lowerLeft) const;

  /// The cell into which an edge leads. `corner` receives the corner that is the edge's owner.
  Cell GetEndCell(int edge, int& corner) const;

  /// The gate between a corner of a cell and the next corner, or NoGate if both are in one patch.
  int GetCellGate(const Cell& cell, int corner) const;

  /// Whether there is a gate of a kind between a corner of a cell and the next corner.
  bool HasCellGate(const Cell& cell, int corner, GateKind kind) const
  {
    const int gate = this->GetCellGate(cell, corner);
    return gate != NoGate && this->Gates[gate].Kind == kind;
  }

  /// Whether all corners of a cell belong to patches and no depth step passes the cell.
  bool IsContinuous(const Cell& cell) const;

private:
  void FindGates();
  void AppendGates(int column, lms3dLabelChanges& changes, std::vector<Gate>& gates) const;
  Gate MakeGate(GridIndex index, int side) const;
  double GetMargin(GridIndex index, int side) const;
  void Classify(Gate& gate) const;
  void LinkEdges();
  int FindNext(int edge) const;
  int GetEdge(GridIndex index, int side) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const double Tolerance;
  std::vector<Gate> Gates;
  /// Two entries for each grid index: its gate upwards and its gate to the right, or NoGate.
  lms3dBeamVector<std::int32_t> GateOf;
  std::vector<std::int32_t> Next;
};

#endif
