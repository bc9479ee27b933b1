// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the borders of patches pass between neighbouring beams, and in which order.
 */
#ifndef lms3dBorderGates_h
#define lms3dBorderGates_h

#include "LocalMap/Patches/lms3dPatches.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * A gate is the arc between two neighbouring beams of different patches, or on both sides of a depth
 * step. The borders pass it, and never touch a beam; so however they are straightened, each beam
 * stays on its side.
 *
 * Each gate has two edges, one for each patch; the edge of a place without a return is void. The
 * edges of a patch follow each other around it, the patch to the left as the sensor sees it.
 */
class lms3dBorderGates
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;

  enum GateKind : std::uint8_t
  {
    /// A depth step, or a miss beyond: each side has a border of its own.
    DepthStep,
    /// One surface, and the planes meet here: a border for both.
    Crease,
    /// One surface, but the planes do not meet: two borders, close by, with a band between them.
    Offset
  };

  struct Gate
  {
    /// The places at both ends, the second up or right of the first.
    std::array<GridIndex, 2> Ends;
    GateKind Kind;
    /// The part that borders may pass, and where they had best pass, from 0 at the first end.
    double Low;
    double High;
    double Best;
  };

  /// The share of a gate at each end that borders keep off, so that beams are never grazed.
  static constexpr double Margin = 0.1;
  /// The same at creases, where a grazed beam meets either side at the right range.
  static constexpr double CreaseMargin = 0.001;
  static constexpr int NoGate = -1;

  /// `tolerance` is what the planes of a crease may differ by, metres along the beam.
  lms3dBorderGates(const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance);

  int GetNumberOfEdges() const { return 2 * static_cast<int>(this->Gates.size()); }
  const Gate& GetGate(int edge) const { return this->Gates[edge / 2]; }
  static int GetTwin(int edge) { return edge ^ 1; }
  GridIndex GetOwner(int edge) const { return this->Gates[edge / 2].Ends[edge & 1]; }
  std::int32_t GetPatch(int edge) const { return this->Patches.Labels[this->GetOwner(edge)]; }
  bool IsVoid(int edge) const { return this->GetPatch(edge) < 0; }
  /// The side of its owner that an edge lies on.
  int GetSide(int edge) const;
  double GetTolerance() const { return this->Tolerance; }

  /// Whether a patch has so few returns that its plane tells nothing beyond them.
  bool HasFewReturns(std::int32_t patch) const;

  int GetNext(int edge) const { return this->Next[edge]; }

  /// Whether the border goes on from an edge to the next without a third patch to meet.
  bool IsRegular(int edge) const;

  /// A cell between four places, clockwise from its lower left one.
  struct Cell
  {
    GridIndex LowerLeft;
    std::array<GridIndex, 4> Corners;
  };
  Cell GetCell(GridIndex lowerLeft) const;

  /// The cell in which an edge ends, and which of its corners is the edge's owner.
  Cell GetEndCell(int edge, int& corner) const;

  /// The gate between a corner of a cell and the next one, or NoGate within a patch.
  int GetCellGate(const Cell& cell, int corner) const;

private:
  void FindGates();
  void AddGate(GridIndex index, int side);
  void Classify(Gate& gate) const;
  void FollowBorders();
  int FindNext(int edge) const;
  int GetEdge(GridIndex index, int side) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const double Tolerance;
  std::vector<Gate> Gates;
  /// Of each place upwards and to the right.
  std::vector<std::int32_t> GateOf;
  std::vector<std::int32_t> Next;
};

#endif
