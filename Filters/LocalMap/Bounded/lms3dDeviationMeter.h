// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures how far the returns of patches are from their triangles.
 */
#ifndef lms3dDeviationMeter_h
#define lms3dDeviationMeter_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"
#include "LocalMap/Patches/lms3dPatches.h"

#include <tbb/tbb_allocator.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/**
 * The deviation of a return is its distance to the nearest of the triangles that its beam hits. A
 * beam along an edge hits the triangles on both sides. All distances are metres.
 *
 * Beams must be regular. lms3dRayCheck measures others.
 */
class lms3dDeviationMeter
{
public:
  /// Keeps references.
  lms3dDeviationMeter(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBoundedMap& map)
    : Sphere(sphere)
    , Patches(patches)
    , Map(map)
    , Marks(sphere.GetSize())
  {
    this->Corners.reserve(map.Points.size());
    for (const lms3dVector& point : map.Points)
    {
      this->Corners.emplace_back(point);
    }
  }

  /// The largest deviation of all returns on patches, except the returns of poles. `expected`,
  /// metres, is a guess of the result. A poor one costs time only: if a return deviates by more
  /// than 0.7 of it, only such returns are measured, otherwise all. Uses the threads of the calling
  /// TBB arena.
  double GetLargest(double expected);

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Distances = std::vector<std::pair<GridIndex, double>>;

  /// What is known of the beam of a return: it hits a triangle farther than the threshold, or
  /// another one within the threshold, too.
  enum Mark : std::uint8_t
  {
    NoMark,
    IsFar,
    IsNear
  };

  double GetLargestAbove(double threshold);
  Distances FindDistances(double threshold) const;
  void MarkNear(double threshold, const Distances& distances);
  lms3dTriangleRasterizer MakeRasterizer(std::size_t triangle) const;
  void Measure(std::size_t triangle, double threshold, Distances& distances) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBoundedMap& Map;
  /// By grid index.
  std::vector<std::atomic<Mark>, tbb::tbb_allocator<std::atomic<Mark>>> Marks;
  /// The points of the map.
  std::vector<lms3dTriangleCorner> Corners;
};

#endif
