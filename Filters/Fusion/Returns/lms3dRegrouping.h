// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Replaces regions of few returns by fewer triangles.
 */
#ifndef lms3dRegrouping_h
#define lms3dRegrouping_h

#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Returns/lms3dRegroupingPlace.h"
#include "Fusion/Scans/lms3dBeamTable.h"

#include <cstddef>
#include <vector>

/**
 * Few beams of each scan meet a thing such as the leg of a chair, so that no scan shows its planes.
 * The returns of all scans do: they are grouped anew, and the groups become planes, if these have
 * fewer triangles than the weak planes whose returns they are. Only a few places are looked at
 * after each scan, first where planes have gained the most triangles. Planes of a place that have
 * no group in common go or stay on their own. The plane at which a place began begins no other one
 * until it has more triangles. Its neighbours may begin places of their own, which have other
 * neighbours.
 */
class lms3dRegrouping
{
public:
  /// Keeps references. The tables say which beams of a scan are neighbours.
  lms3dRegrouping(lms3dFusedPlanes& planes, const lms3dTablesOfScans& tables)
    : Planes(planes)
    , Tables(tables)
  {
  }

  /// Makes planes for the returns of weak planes. All of these stay. Returns whether it made any.
  bool MakePlanes();

  /// To be called when the new planes have triangles. Clears them, or the planes that they replace.
  void Choose();

private:
  using Place = lms3dRegroupingPlace;

  bool IsCandidate(int number) const;
  std::size_t CountTriangles(const std::vector<int>& numbers) const;
  std::vector<int> FindSeeds() const;
  std::vector<Place> FindPlaces();
  Place FindPlace(int seed);
  void AddPlace(Place&& place);
  void FillPlanes();
  std::size_t CountFacets(const Place& place) const;
  bool IsBetter(const Place& place) const;
  void Clear(const std::vector<int>& numbers);
  /// Adds returns to planes that cover them, or gives them facets.
  void AddLeft(const std::vector<lms3dMappedReturn>& left);

  lms3dFusedPlanes& Planes;
  const lms3dTablesOfScans& Tables;
  std::vector<Place> Places;
  /// The planes whose returns are in a place.
  std::vector<bool> IsTaken;
};

#endif
