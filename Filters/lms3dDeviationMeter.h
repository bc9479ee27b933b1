// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures how far the returns of a patch are from its triangles.
 */
#ifndef lms3dDeviationMeter_h
#define lms3dDeviationMeter_h

#include "lms3dBeamsOfTriangle.h"
#include "lms3dPatches.h"

#include <array>
#include <utility>
#include <vector>

/**
 * The distance of a return is that to the nearest of the triangles that its beam meets, or all but
 * meets: a beam along an edge belongs to both sides.
 */
class lms3dDeviationMeter
{
public:
  using Triangle = std::array<const lms3dCorner*, 3>;

  /// Keeps references.
  lms3dDeviationMeter(const lms3dBeamSphere& sphere, const lms3dPatches& patches, int patch)
    : Sphere(sphere)
    , Patches(patches)
    , Patch(patch)
  {
  }

  /**
   * The largest distance, metres, of all returns of the patch but those of poles. None is farther
   * than `limit` along its beam; the tighter that is, the fewer returns are measured.
   */
  double GetLargest(const std::vector<Triangle>& triangles, double limit) const;

private:
  using Place = lms3dBeamSphere::Place;

  double GetLargestAbove(const std::vector<Triangle>& triangles, double least) const;
  void Measure(
    const Triangle& triangle, double least, std::vector<std::pair<Place, double>>& distances) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const int Patch;
};

#endif
