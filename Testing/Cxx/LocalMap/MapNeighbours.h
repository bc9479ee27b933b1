// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where surface may be, by the scene and by the returns around a place.
 */
#ifndef MapNeighbours_h
#define MapNeighbours_h

#include "LocalMap/MapJudge.h"

#include <array>
#include <memory>
#include <set>
#include <vector>

class MapNeighbours
{
public:
  /// Keeps references to the map and, if it is not null, to the same map with the scan without
  /// errors.
  MapNeighbours(const MapCase& map, const MapCase* ideal);

  /// Keeps a reference.
  explicit MapNeighbours(const MapCase& map);

  /// Whether surface at a point may be met by a beam that returned.
  bool ExplainOnBeam(const Vector& point, const ScanGrid::Beam& beam) const;

  /// Whether a triangle may be met at a point, at a place between beams.
  bool ExplainBetween(
    const Vector& point, const ScanGrid::Place& place, const std::array<Vector, 3>& triangle) const;

  /// Whether the four beams around a place, in a row the two cells beside it, are on one surface.
  bool AreJoined(const ScanGrid::Place& place) const;

  /// Whether a return is a corner of a triangle.
  bool IsInTriangle(const Vector& point) const { return this->Vertices.count(point) > 0; }

  /// The scene, or none.
  const TriangleTree* GetScene() const { return this->Scene.get(); }

  /// The neighbours in the scan without errors, or none.
  const MapNeighbours* GetIdeal() const { return this->Ideal.get(); }
  const MapCase& GetMap() const { return this->Map; }

private:
  bool ExplainOnBeamAlone(const Vector& point, const ScanGrid::Beam& beam) const;
  bool ExplainBetweenAlone(
    const Vector& point, const ScanGrid::Place& place, const std::array<Vector, 3>& triangle) const;
  bool IsAtScene(const Vector& point, double cells) const;
  Vector GetSceneBehind(const Vector& point) const;
  bool IsBeside(const Vector& point, const ScanGrid::Beam& beam) const;
  bool IsInPlaneOf(const Vector& point, const ScanGrid::Beam& beam) const;
  bool IsSupportedBy(const std::array<Vector, 3>& triangle, const ScanGrid::Beam& beam) const;
  bool IsSpannedBy(const Vector& point, const Vector& behind, const ScanGrid::Beam& lowest) const;
  bool IsSpannedAround(const Vector& point, const ScanGrid::Place& place) const;

  const MapCase& Map;
  double Bound;
  std::unique_ptr<TriangleTree> Scene;
  std::set<Vector> Vertices;
  std::unique_ptr<const MapNeighbours> Ideal;
};

#endif
