// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The depth steps and slopes that a scene has between the beams of a scan, and which of them
 * a map bridges or leaves open.
 */
#ifndef TrueSteps_h
#define TrueSteps_h

#include "Fixtures/ScanGrid.h"
#include "Fixtures/TriangleTree.h"

#include <vtkPolyData.h>

#include <memory>
#include <vector>

/// Rays between two beams show whether the range jumps from the one to the other. A jump to a thing
/// and back again, which no beam meets, does not count.
class TrueSteps
{
public:
  /// Two neighbours, and how far the range jumps between them, metres.
  struct Step
  {
    ScanGrid::Beam Beam;
    ScanGrid::Beam Next;
    double Jump;
  };

  /// Finds jumps of more than twice the tolerance between returns whose ranges differ by as much.
  /// The tolerance is `depthStep`, metres, plus `share` of the nearer range. `scan` has no errors.
  TrueSteps(vtkPolyData* scan, vtkPolyData* scene, double depthStep, double share);

  const std::vector<Step>& GetSteps() const { return this->Steps; }

  /// Pairs whose ranges differ as much and between which the range does not jump, with that
  /// difference.
  const std::vector<Step>& GetSlopes() const { return this->Slopes; }

  /// The number of steps at which the map has a surface from one beam to the other without a
  /// quarter of the jump.
  int CountBridged(vtkPolyData* map) const;
  /// The number of slopes at which the map has no such surface, or one that jumps by a quarter of
  /// the difference.
  int CountOpen(vtkPolyData* map) const;

private:
  void AddIfStep(const TriangleTree& scene, const ScanGrid::Beam& beam, const ScanGrid::Beam& next);
  double GetJump(
    const TriangleTree& surface, const ScanGrid::Beam& a, const ScanGrid::Beam& b) const;
  std::unique_ptr<TriangleTree> MakeTree(vtkPolyData* triangles) const;

  const ScanGrid Grid;
  const double DepthStep;
  const double Share;
  std::vector<Step> Steps;
  std::vector<Step> Slopes;
};

#endif
