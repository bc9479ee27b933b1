// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns around the speckles of a map, and their plane.
 */
#ifndef SpeckleSurroundings_h
#define SpeckleSurroundings_h

#include "LocalMap/MapJudge.h"

#include <set>

/// The return of a beam; none if the beam is not in the grid.
vtkIdType GetReturnOf(const MapCase& map, const ScanGrid::Beam& beam);

/// Calls visit(beam, return) for a beam and its neighbours, diagonals included, if they returned.
template <typename Visitor>
void ForEachReturnNear(const MapCase& map, const ScanGrid::Beam& beam, const Visitor& visit)
{
  for (int i = 0; i < 9; ++i)
  {
    const ScanGrid::Beam next = { beam.Turn + i / 3 - 1, beam.Number + i % 3 - 1 };
    const vtkIdType number = GetReturnOf(map, next);
    if (number != ScanGrid::NoReturn)
    {
      visit(next, number);
    }
  }
}

/// The returns around a speckle, and the plane that fits them best.
class SpeckleSurroundings
{
public:
  /// `first` has a return of the speckle. Keeps a reference.
  SpeckleSurroundings(const MapCase& map, const ScanGrid::Beam& first);

  /// Whether the plane explains all returns within a distance along their beams, metres.
  bool AreOnOnePlane(double tolerance) const;

  /// Whether all beams around the speckle returned.
  bool AreWhole() const { return this->IsWhole; }

  /// Where a beam meets the plane, metres.
  double GetRange(const Vector& direction) const { return 1.0 / Dot(this->Plane, direction); }

private:
  void Find(const ScanGrid::Beam& first);
  void FitPlane();

  const MapCase& Map;
  std::set<vtkIdType> Returns;
  bool IsWhole = true;
  Vector Plane = {};
};

#endif
