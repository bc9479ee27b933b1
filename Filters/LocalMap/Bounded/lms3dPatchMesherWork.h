// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The mesh of a patch while lms3dPatchMesher refines it.
 */
#ifndef lms3dPatchMesherWork_h
#define lms3dPatchMesherWork_h

#include "LocalMap/Bounded/lms3dPatchMesher.h"

#include <array>
#include <cstdint>
#include <vector>

/// The mesh of one patch while it is refined.
struct lms3dPatchMesher::Work
{
  /// A beam that hits a triangle beyond the bound.
  struct Violation
  {
    GridIndex Beam;
    int Triangle;
    /// The range of the hit, metres; negative if the plane of the triangle does not meet the beam.
    double Range;
    double Deviation;
  };

  Work(const lms3dPatchOutlines& outlines, int patch, int members, const lms3dPlane& plane)
    : Patch(patch)
    , Members(members)
    , Triangulation(outlines, patch, plane.Q)
  {
  }

  /// Keeps the worst violation of each triangle, or all.
  void AddViolation(const Violation& violation)
  {
    if (!this->KeepsWorstOnly || this->Violations.empty() ||
      this->Violations.back().Triangle != violation.Triangle)
    {
      this->Violations.push_back(violation);
    }
    else if (violation.Deviation > this->Violations.back().Deviation)
    {
      this->Violations.back() = violation;
    }
  }

  const int Patch;
  const int Members;
  lms3dPatchTriangulation Triangulation;
  bool KeepsWorstOnly = true;
  /// The number of the patch's beams that hit a triangle.
  int Covered = 0;
  /// Whether all triangles have been checked, and only beams of the patch hit them.
  bool CoversOwnBeamsOnly = false;
  std::vector<Violation> Violations;
  /// The corners of each triangle when its beams were last checked.
  std::vector<std::array<std::int32_t, 3>> CheckedTriangles;
};

#endif
