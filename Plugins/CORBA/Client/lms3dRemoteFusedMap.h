// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A client's copy of a server's map of many scans.
 */
#ifndef lms3dRemoteFusedMap_h
#define lms3dRemoteFusedMap_h

#include "Client/lms3dFusedMapChanges.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

class vtkPolyData;

/// Holds the map of the last Update(), and fetches only what has changed since. For one thread.
class lms3dRemoteFusedMap
{
public:
  /**
   * Fetches and checks the changes, in one message if they fit. Returns false if the map is the
   * same as before. Calls `beforePart` before each message; an exception from it ends the fetch.
   * The map is then as before, or empty if the changes do not add up. Throws LMS3D::NoFusedMap,
   * LMS3D::FusedMapGone if the server drops states before they are fetched, std::runtime_error if
   * the data are invalid, and CORBA::SystemException, which is CORBA::BAD_OPERATION for an older
   * server.
   */
  bool Update(
    LMS3D::LaserScanner_ptr scanner, const std::function<void()>& beforePart = [] {});

  /**
   * Takes over changes that pass both checks of lms3dRemoteFusedMapCheck.h. Throws
   * std::runtime_error if they do not add up to a map, or to one of more than 16,000,000 points;
   * the map is then empty.
   */
  void Apply(const lms3dFusedMapChanges& changes);

  /// The header of the last Update(). Its number is 0 before the first.
  const LMS3D::FusedMapHeader& GetHeader() const { return this->Header; }

  /// The regions, points and triangles of the last Update(), as they are sent.
  std::uint64_t GetReceivedBytes() const;

  /**
   * Fills an empty vtkPolyData with the triangles (metres, world coordinates), with the cell array
   * `RegionId` (int32) and the field data `NumberOfScans` (int32), `State`, `ScanNumber` of the
   * newest scan, `Incarnation` (uint64) and `Scene`.
   */
  void Fill(vtkPolyData* map) const;

private:
  struct Region
  {
    std::vector<float> Points;
    std::vector<std::uint32_t> Triangles;
  };

  /// Without the points of the regions that changes replace.
  std::size_t CountPointsWith(const lms3dFusedMapChanges& changes) const;
  /// Empties the map, and throws std::runtime_error.
  [[noreturn]] void Refuse(const char* problem);
  void FillTriangles(vtkPolyData* map) const;

  LMS3D::FusedMapHeader Header{};
  std::map<std::uint32_t, Region> Regions;
};

#endif
