// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides whether the border of the surface may leave out a vertex or move.
 */
#ifndef lms3dBorderShortcuts_h
#define lms3dBorderShortcuts_h

#include "LocalMap/Borders/lms3dDepthStepMargins.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <vector>

/**
 * The border of the surface may change where the returns support its new ranges. A border may run
 * straight from one vertex to the next but one if it passes at least the same
 * gates (lms3dBorderGates), in the ranges that the returns support there (lms3dRangeSupport), and
 * if no beam lies between the old border and the new one. Beams must be regular.
 */
class lms3dBorderShortcuts
{
public:
  using Vertex = lms3dVertexStars::Vertex;

  /// Keeps references. `tolerance` is that of lms3dBorderGates, metres.
  lms3dBorderShortcuts(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, double tolerance);

  /// Whether the border from `last` over `middle` to `next`, with the surface to the left, may
  /// leave out `middle`.
  bool IsAllowed(const Vertex& last, const Vertex& middle, const Vertex& next) const;

  /// Whether it may do so if the surface goes on at the border, so that any range is supported.
  bool PassesSameGates(const Vertex& last, const Vertex& middle, const Vertex& next) const;

  enum class Support
  {
    NoDepthStep,
    Supported,
    /// Or the gates are not certain.
    Unsupported
  };

  /// Whether the returns support the ranges of the border from one vertex to the next, with the
  /// surface to the left, at each depth step that it passes. Only steps between returns with
  /// patches count, not the gates to missing beams. Whether there is a depth step does not depend
  /// on the ranges of the vertices.
  Support GetSupportAtDepthSteps(const Vertex& from, const Vertex& to) const;

private:
  using GridIndex = lms3dBeamSphere::GridIndex;

  /// Radians within which a vertex lies in a gate.
  static constexpr double Rounding = 1e-9;

  /// The arc from a beam to its neighbour above or to its right.
  struct Gate
  {
    GridIndex Index;
    int Side;

    bool operator<(const Gate& other) const
    {
      return this->Index != other.Index ? this->Index < other.Index : this->Side < other.Side;
    }
  };

  /// The part of an arc of the border.
  struct Arc
  {
    const lms3dVector& From;
    const lms3dVector& To;
    lms3dVector Normal;
    double Tolerance;
  };

  template <typename Predicate>
  bool MayLeaveOut(const Vertex& last, const Vertex& middle, const Vertex& next,
    const Predicate& isSupported) const;
  bool AreBeamsBetween(const Vertex& last, const Vertex& middle, const Vertex& next) const;
  bool FindGates(const Vertex& from, const Vertex& to, std::vector<Gate>& gates) const;
  void AppendGatesOfRows(const Arc& arc, int column, double width, double low, double high,
    std::vector<Gate>& gates) const;
  int FindRowAbove(double tangent) const;
  bool IsDepthStep(const Gate& gate) const;
  bool IsSupported(const Gate& gate, const Vertex& from, const Vertex& to) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dDepthStepMargins Margins;
};

#endif
