// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures how far the returns of patches are from their triangles.
 */
#ifndef lms3dDeviationMeter_h
#define lms3dDeviationMeter_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Patches/lms3dPatches.h"

#include <cstddef>
#include <utility>
#include <vector>

/**
 * The distance of a return is that to the nearest of its patch's triangles that its beam meets, or
 * all but meets: a beam along an edge belongs to both sides.
 */
class lms3dDeviationMeter
{
public:
  /// The triangles of a patch, from one of the map's to before another.
  struct Part
  {
    std::int32_t Patch;
    std::size_t First;
    std::size_t Last;
    /// No return is farther along its beam, metres.
    double OnBeams;
  };

  /// Keeps references.
  lms3dDeviationMeter(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBoundedMap& map)
    : Sphere(sphere)
    , Patches(patches)
    , Map(map)
  {
  }

  /// The largest distance, metres, of all returns of these patches but those of poles. Few are
  /// measured: those that may be the farthest.
  double GetLargest(std::vector<Part> parts) const;

private:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Distances = std::vector<std::pair<GridIndex, double>>;

  double GetLargest(const Part& part, double least) const;
  double GetLargestAbove(const Part& part, double least) const;
  void Measure(const Part& part, std::size_t triangle, double least, Distances& distances) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBoundedMap& Map;
};

#endif
