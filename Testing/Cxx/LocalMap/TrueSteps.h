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
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

/// Rays between two beams show whether the range jumps from the one to the other. A jump to a thing
/// and back again, which no beam meets, does not count.
class TrueSteps
{
public:
  using Beam = ScanGrid::Beam;

  /// Two neighbours, and how far the range jumps between them, metres.
  struct Step
  {
    Beam From;
    Beam Next;
    double Jump;
  };

  /// Finds jumps of more than twice the tolerance between returns whose ranges differ by as much.
  /// The tolerance is `depthStep`, metres, above 0, plus `share` of the nearer range. Changes by
  /// less than half of `depthStep` from ray to ray are no jumps. `scan` has no errors.
  TrueSteps(vtkPolyData* scan, vtkPolyData* scene, double depthStep, double share);

  const std::vector<Step>& GetSteps() const { return this->Steps; }

  /// Pairs whose ranges differ as much and between which the range does not jump, with that
  /// difference.
  const std::vector<Step>& GetSlopes() const { return this->Slopes; }

  /**
   * The steps that the returns show: on both sides, the last three returns before the step lie on
   * the plane of the triangle that the last one hits. The planes of both sides do not meet between
   * the beams: one is before the other return and the other plane behind, each by more than
   * `margin`, metres. With an `error` of the ranges, metres, each plane must also miss the other
   * return in inverse range by more than the error that the plane's last two returns and the other
   * return cause. Along a turn, the returns beside the last two, towards the horizon, must lie
   * on the plane as well: the tilt of the plane follows from them.
   */
  std::vector<Step> FindShown(double margin, double error) const;

  /// The number of steps at which the map has a surface from one beam to the other without a
  /// quarter of the jump.
  int CountBridged(vtkPolyData* map) const { return this->CountBridged(map, this->Steps); }
  int CountBridged(vtkPolyData* map, const std::vector<Step>& steps) const;
  /// The number of slopes at which the map has no such surface, or one that jumps by a quarter of
  /// the difference.
  int CountOpen(vtkPolyData* map) const { return this->CountOpen(map, this->Slopes); }
  int CountOpen(vtkPolyData* map, const std::vector<Step>& slopes) const;

private:
  /// The points p with Normal . p = Offset.
  struct Plane
  {
    Vector Normal;
    double Offset;
  };

  Plane GetPlane(const Beam& beam) const;
  bool IsOn(const Plane& plane, const Beam& beam) const;
  bool IsPlane(const Beam& last, const Beam& other) const;
  double GetGap(const Beam& from, const Beam& to) const;
  bool IsCertain(const Beam& from, const Beam& to, double error) const;
  void AddIfStep(const TriangleTree& scene, const Beam& beam, const Beam& next);
  double GetSmallChange() const;
  double GetJump(const TriangleTree& surface, const Beam& a, const Beam& b) const;
  std::unique_ptr<TriangleTree> MakeTree(vtkPolyData* triangles) const;

  const ScanGrid Grid;
  const vtkSmartPointer<vtkPolyData> Scene;
  const double DepthStep;
  const double Share;
  std::vector<Step> Steps;
  std::vector<Step> Slopes;
};

#endif
